// The buttons that switch marks on and off, each with a letter as its key.

export class Tools {
  constructor(place, changed) {
    Object.assign(this, { place, changed, tools: [], keys: new Map() });
  }

  // Add a switch; `make` builds its mark when it is first switched on.
  add(name, key, on, make, scene) {
    const button = document.createElement("button");
    const tool = { name, button, on, make, scene, mark: null };
    button.type = "button";
    button.textContent = name;
    button.title = `${name} (${key.toUpperCase()})`;
    button.addEventListener("click", () => this.toggle(tool));
    this.keys.set(key, tool);
    this.tools.push(tool);
    this.place.append(button);
    this.apply(tool);
    return tool;
  }

  // Add a menu of actions: [name, key, act].
  menu(name, actions) {
    const menu = document.createElement("select");
    menu.id = name.toLowerCase();
    menu.setAttribute("aria-label", name);
    menu.append(new Option(name, ""), ...actions.map(([words, key]) =>
      new Option(`${words} (${key.toUpperCase()})`, key)));
    menu.addEventListener("change", () => {
      this.keys.get(menu.value)?.act();
      menu.value = "";
    });
    for (const [words, key, act] of actions) this.keys.set(key, { name: words, act });
    this.place.append(menu);
  }

  // All keys, each with what it switches or does.
  get keyed() { return [...this.keys].map(([key, { name }]) => [key.toUpperCase(), name]); }

  toggle(tool) {
    tool.on = !tool.on;
    this.apply(tool);
    this.changed();
  }

  apply(tool) {
    if (tool.on && !tool.mark) {
      tool.mark = tool.make();
      if (tool.mark.group) tool.scene.add(tool.mark.group);
    }
    if (tool.mark?.group) tool.mark.group.visible = tool.on;
    tool.mark?.show?.(tool.on);
    tool.button.setAttribute("aria-pressed", String(tool.on));
  }

  key(event) {
    const tool = this.keys.get(event.key.toLowerCase());
    if (!tool || event.ctrlKey || event.metaKey || event.altKey) return false;
    if (tool.act) tool.act(); else this.toggle(tool);
    return true;
  }

  // Bring the marks that are on to a time.
  update(time) { for (const tool of this.tools) if (tool.on) tool.mark.update?.(time); }
}
