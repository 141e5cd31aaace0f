package robotran.brick.controls

import robotran.brick.kind.BrickKind

/**
 * The buttons of all bricks.
 *
 * @property kind the brick that has it.
 * @property label what is printed on it or, where nothing is, its name in the brick's own manual.
 */
enum class BrickButton(val kind: BrickKind, val label: String) {
    ON_OFF(BrickKind.RCX, "On-Off"),
    VIEW(BrickKind.RCX, "View"),
    PRGM(BrickKind.RCX, "Prgm"),
    RUN(BrickKind.RCX, "Run"),

    /** The orange button of an NXT. */
    ENTER(BrickKind.NXT, "Enter"),
    LEFT(BrickKind.NXT, "Left"),
    RIGHT(BrickKind.NXT, "Right"),

    /** The dark grey button of an NXT. */
    ESCAPE(BrickKind.NXT, "Escape"),
    ;

    companion object {
        private val OF_KIND = BrickKind.entries.map { kind -> entries.filter { it.kind == kind } }

        /** The buttons of a [kind] of brick. */
        fun of(kind: BrickKind): List<BrickButton> = OF_KIND[kind.ordinal]
    }
}

/** The button that starts the selected program of a brick. */
val BrickKind.startButton: BrickButton
    get() = when (this) {
        BrickKind.RCX -> BrickButton.RUN
        BrickKind.NXT -> BrickButton.ENTER
    }
