package robotran.brick.kind

/**
 * What a module has for each kind of brick. [make] makes it when it is first asked for, so that a page that has just been
 * opened loads and sets up nothing of bricks that its robots do not have.
 */
class ByBrick<T>(make: (BrickKind) -> T) {
    private val made = BrickKind.entries.map { kind -> lazy(LazyThreadSafetyMode.PUBLICATION) { make(kind) } }

    operator fun get(kind: BrickKind): T = made[kind.ordinal].value
}
