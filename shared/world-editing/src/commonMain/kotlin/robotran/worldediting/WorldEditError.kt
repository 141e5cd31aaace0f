package robotran.worldediting

/** Why an edit was rejected; the world is unchanged. */
sealed interface WorldEditError {
    /** The world already has the max number of elements of this kind. */
    data class TooMany(val kind: ElementKind) : WorldEditError

    /** Polygons, lines and the template have too many points together, or one of them alone. */
    data object TooManyPoints : WorldEditError

    /** An element would be too far from the paper. */
    data object TooFar : WorldEditError

    /** An element would be too small or too large. */
    data object InvalidSize : WorldEditError

    /** A value is out of range. */
    data object OutOfRange : WorldEditError

    /** A polygon needs three corners, a line two points. */
    data object TooFewCorners : WorldEditError

    /** Two consecutive points of a line would be equal. */
    data object CoincidentPoints : WorldEditError

    /** Another element has this name. */
    data class NameTaken(val name: String) : WorldEditError

    /** A text is empty, too long or contains invisible characters. */
    data object InvalidText : WorldEditError

    /** A world needs a robot. */
    data object LastRobot : WorldEditError

    /** A goal refers to a line on the paper, and there is none. */
    data object NeedsLine : WorldEditError

    /** A goal refers to the template, and there is none. */
    data object NeedsTemplate : WorldEditError

    /** Goals would be nested too deep. */
    data object TooDeep : WorldEditError
}
