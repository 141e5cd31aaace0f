package robotran.uikit

import androidx.compose.ui.unit.dp

/**
 * Distances between and around elements: multiples of 4, finer steps only inside of controls. Paddings and gaps have
 * no other values (`DesignTokensTest`).
 */
object Space {
    /** Between parts of one sign. */
    val HAIR = 2.dp

    /** Between lines that belong together. */
    val TINY = 4.dp

    /** Between an icon and its word. */
    val SMALL = 8.dp

    /** Between elements of a group. */
    val MEDIUM = 12.dp

    /** Around the content of a card, and between groups. */
    val LARGE = 16.dp

    /** Around the content of a page. */
    val PAGE = 24.dp

    /** Between sections of a page with room. */
    val WIDE = 32.dp
}
