package robotran.worldediting

/** Why an edit was rejected; the world is unchanged. */
sealed interface EditError {
    /** The world already has the max number of elements of this kind. */
    data class TooMany(val kind: ElementKind) : EditError

    /** Polygons, lines and the template have too many points together, or one of them alone. */
    data object TooManyPoints : EditError

    /** An element would be too far from the paper. */
    data object TooFar : EditError

    /** An element would be too small or too large. */
    data object InvalidSize : EditError

    /** A value is out of range. */
    data object OutOfRange : EditError

    /** A polygon needs three corners, a line two points. */
    data object TooFewCorners : EditError

    /** Two consecutive points of a line would be equal. */
    data object CoincidentPoints : EditError

    /** Another element has this name. */
    data class NameTaken(val name: String) : EditError

    /** A text is empty, too long or contains invisible characters. */
    data object InvalidText : EditError

    /** A world needs a robot. */
    data object LastRobot : EditError

    /** A goal refers to a line on the paper, and there is none. */
    data object NeedsLine : EditError

    /** A goal refers to the template, and there is none. */
    data object NeedsTemplate : EditError

    /** Goals would be nested too deep. */
    data object TooDeep : EditError
}
