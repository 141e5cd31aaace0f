package robotran.ui.world

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.AppMenu
import robotran.ui.resources.Res
import robotran.ui.resources.sheet_layer_goals
import robotran.ui.resources.sheet_layer_grid
import robotran.ui.resources.sheet_layer_names
import robotran.ui.resources.sheet_layer_sensors
import robotran.ui.resources.sheet_layer_trail
import robotran.ui.resources.sheet_show
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Shapes
import robotran.ui.theme.TextSizes
import robotran.workshop.state.SheetLayer

/** A button that opens a list of the sheet's optional layers. */
@Composable
internal fun LayerMenu(shown: Set<SheetLayer>, onSwitch: (SheetLayer, Boolean) -> Unit) {
    var open by remember { mutableStateOf(false) }
    Box {
        SheetButton(SheetIcons.LAYERS, stringResource(Res.string.sheet_show), "sheet-show") { open = true }
        AppMenu(open, { open = false }) {
            for (layer in SheetLayer.entries) {
                val on = layer in shown
                DropdownMenuItem(
                    text = { Text(stringResource(layer.words), fontSize = TextSizes.BODY) },
                    onClick = { onSwitch(layer, !on) },
                    modifier = Modifier.testTag("layer-${layer.name.lowercase()}").semantics {
                        role = Role.Checkbox
                        toggleableState = ToggleableState(on)
                    },
                    leadingIcon = { Tick(on) },
                )
            }
        }
    }
}

@Composable
private fun Tick(on: Boolean) {
    val colour = LocalRobotranColours.current.onPane
    Box(Modifier.size(24.dp).border(2.dp, colour, Shapes.TINY).padding(3.dp)) {
        if (on) Canvas(Modifier.matchParentSize()) { with(SheetIcons.TICK) { draw(colour) } }
    }
}

private val SheetLayer.words: StringResource
    get() = when (this) {
        SheetLayer.SENSORS -> Res.string.sheet_layer_sensors
        SheetLayer.TRAIL -> Res.string.sheet_layer_trail
        SheetLayer.NAMES -> Res.string.sheet_layer_names
        SheetLayer.GRID -> Res.string.sheet_layer_grid
        SheetLayer.GOALS -> Res.string.sheet_layer_goals
    }
