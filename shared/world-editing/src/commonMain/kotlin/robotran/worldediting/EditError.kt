package robotran.worldediting

/** Why something could not be done to a world; it is as it was. */
sealed interface EditError {
    /** There are as many things of this kind as a world can have. */
    data class TooMany(val kind: ElementKind) : EditError

    /** Polygons, lines and the drawing have more points together than a world can have, or one of them alone. */
    data object TooManyPoints : EditError

    /** Something would be too far from the paper. */
    data object TooFar : EditError

    /** Something would be too small or too large. */
    data object NoSuchSize : EditError

    /** A figure is beyond what a world can have. */
    data object OutOfRange : EditError

    /** A polygon needs three corners, a line two points. */
    data object TooFewCorners : EditError

    /** Two points of a line would be at one place. */
    data object CoincidentPoints : EditError

    /** Somebody else is called so. */
    data class NameTaken(val name: String) : EditError

    /** A text is empty, too long or has characters that cannot be seen. */
    data object NoSuchText : EditError

    /** A world needs a robot. */
    data object LastRobot : EditError

    /** A goal is about a line on the paper, and there is none. */
    data object NeedsLine : EditError

    /** A goal is about the drawing to be traced, and there is none. */
    data object NeedsTemplate : EditError

    /** Goals would lie too deep in one another. */
    data object TooDeep : EditError
}
