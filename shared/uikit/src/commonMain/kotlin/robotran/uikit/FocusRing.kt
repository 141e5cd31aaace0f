package robotran.uikit

import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusEventModifierNode
import androidx.compose.ui.focus.FocusState
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.node.CompositionLocalConsumerModifierNode
import androidx.compose.ui.node.GlobalPositionAwareModifierNode
import androidx.compose.ui.node.ModifierNodeElement
import androidx.compose.ui.node.currentValueOf
import androidx.compose.ui.platform.InspectorInfo
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/**
 * A ring around the focused element while keys are in use, see [areKeysInUse]. It is drawn over everything in the
 * window, so that nothing cuts it off.
 *
 * @param isInside whether the ring is within the bounds, for a pane beside other panes.
 */
fun Modifier.focusRing(cornerRadius: Dp = 12.dp, isInside: Boolean = false): Modifier =
    this then FocusRingElement(cornerRadius, isInside)

private data class FocusRingElement(val cornerRadius: Dp, val isInside: Boolean) :
    ModifierNodeElement<FocusRingNode>() {
    override fun create() = FocusRingNode(cornerRadius, isInside)

    override fun update(node: FocusRingNode) {
        node.cornerRadius = cornerRadius
        node.isInside = isInside
    }

    override fun InspectorInfo.inspectableProperties() {
        name = "focusRing"
        properties["cornerRadius"] = cornerRadius
        properties["isInside"] = isInside
    }
}

internal class FocusRingNode(var cornerRadius: Dp, var isInside: Boolean) :
    Modifier.Node(),
    FocusEventModifierNode,
    GlobalPositionAwareModifierNode,
    CompositionLocalConsumerModifierNode {
    private var rings: FocusRings? = null

    var coordinates: LayoutCoordinates? = null
        private set

    override fun onFocusEvent(focusState: FocusState) {
        if (focusState.hasFocus == (rings != null)) return
        leave()
        if (focusState.hasFocus) rings = currentValueOf(LocalFocusRings)?.also { it.add(this) }
    }

    override fun onGloballyPositioned(coordinates: LayoutCoordinates) {
        this.coordinates = coordinates
        rings?.moved()
    }

    override fun onDetach() {
        leave()
        coordinates = null
    }

    private fun leave() {
        rings?.remove(this)
        rings = null
    }
}
