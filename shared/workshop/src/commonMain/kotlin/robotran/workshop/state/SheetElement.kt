package robotran.workshop.state

/**
 * An element on the sheet.
 *
 * @property number its index among the elements of its kind in the world; for regions, among those that [drawSheet]
 * shows; for the template, the index of the stroke.
 */
data class SheetElement(val kind: SheetElementKind, val number: Int)

/** In drawing order, from bottom to top. */
enum class SheetElementKind { MARK, TEMPLATE, REGION, WALL, BARRIER, BLOCK, ROBOT, LAMP }
