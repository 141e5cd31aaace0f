package robotran.uikit

import androidx.compose.runtime.Immutable
import androidx.compose.ui.semantics.SemanticsPropertyKey
import androidx.compose.ui.semantics.SemanticsPropertyReceiver

/**
 * The place of an element in a tree, for screen readers that know trees. Compose has none.
 *
 * @property level how deeply it is nested, from 1.
 * @property position its position among its neighbours, from 1.
 * @property siblings the number of its neighbours with itself.
 * @property isOpen whether what is inside is shown; null if nothing can be inside.
 * @property words its description without level and position, which such a screen reader says of itself; null if the
 * description has neither.
 */
@Immutable
data class TreePlace(
    val level: Int,
    val position: Int,
    val siblings: Int,
    val isOpen: Boolean?,
    val words: String? = null,
)

/** Where an element stands in a tree. */
val TreePlaceKey: SemanticsPropertyKey<TreePlace> = SemanticsPropertyKey("TreePlace")

var SemanticsPropertyReceiver.treePlace: TreePlace by TreePlaceKey

/** Marks a list as a tree: its elements with a [TreePlace] belong to it. */
val IsTreeKey: SemanticsPropertyKey<Boolean> = SemanticsPropertyKey("IsTree")

var SemanticsPropertyReceiver.isTree: Boolean by IsTreeKey
