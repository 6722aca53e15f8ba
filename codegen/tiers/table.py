"""For a moment: the old names."""


def __getattr__(name):
    from coscrew_codegen import tiers
    from coscrew_codegen.tiers.tier import Tier, is_polynomial

    old = {"TIERS": lambda: tiers.MARKED, "Tier": lambda: Tier, "has_tiers": lambda: is_polynomial,
           **{x: lambda x=x: tiers.tier_named(x.lower()) for x in ("FUSED", "ACCURATE", "CERTIFIED")}}
    if name not in old:
        raise AttributeError(name)
    return old[name]()
