"""Pages in notebooks: whole, in a frame of their own, which they cannot leave."""

import html
from dataclasses import dataclass


@dataclass(frozen=True, repr=False)
class FramedPage:
    """A page that notebooks show in a frame."""

    text: str

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.text)}" '
                'sandbox="allow-scripts allow-downloads" '
                'style="width:100%;height:40rem;border:0"></iframe>')
