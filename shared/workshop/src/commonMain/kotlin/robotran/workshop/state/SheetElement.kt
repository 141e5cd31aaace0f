package robotran.workshop.state

/**
 * Something on the sheet.
 *
 * @property number which of its kind it is in the world, from 0; of regions, of those that [drawSheet] shows; of the
 * template's, the stroke.
 */
data class SheetElement(val kind: SheetElementKind, val number: Int)

/** In the order in which they are drawn, the lowest first. */
enum class SheetElementKind { MARK, TEMPLATE, REGION, WALL, BARRIER, BLOCK, ROBOT, LAMP }
