package robotran.ui.world

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.brick.sensors.SensorKind
import robotran.simulation.SessionInput
import robotran.simulation.state.AmbientConditions
import robotran.ui.sheet.has
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.world.World
import robotran.world.WorldLimits
import kotlin.math.max
import kotlin.math.roundToInt

/** Whether any element of [world] reacts to light or temperature. */
internal fun noticesSurroundings(world: World): Boolean = noticesLight(world) || noticesWarmth(world)

private fun noticesLight(world: World) =
    world.lamps.isNotEmpty() || world.robots.any { it.has(SensorKind.LIGHT) || it.has(SensorKind.RCX_LIGHT) }

private fun noticesWarmth(world: World) =
    world.robots.any { it.has(SensorKind.TEMPERATURE) || it.has(SensorKind.NXT_TEMPERATURE) }

/** A button that opens sliders for ambient light and temperature, if any element of the world reacts to them. */
@Composable
internal fun AmbientConditionsMenu(world: World, surroundings: AmbientConditions, inputs: FrameThrottledInput) {
    var open by remember { mutableStateOf(false) }
    Box {
        IconButton(
            SheetIcons.SURROUNDINGS,
            SheetTexts.surroundings(spoken),
            WorldTags.SHEET_SURROUNDINGS,
            IconButtonKind.FLOATING,
        ) {
            open = true
        }
        AppMenu(open, { open = false }) {
            Column(Modifier.width(PANEL_WIDTH).padding(horizontal = 16.dp, vertical = 8.dp)) {
                if (noticesLight(world)) {
                    SurroundingsSlider(
                        SheetTexts.light(spoken),
                        lightWords(surroundings.light)(spoken),
                        WorldTags.LIGHT,
                        surroundings.light.toFloat(),
                        0f..max(MAX_LIGHT, world.ambientLight.toFloat()),
                        inputs,
                    ) { SessionInput.ChangeAmbientLight((it * TENTHS).roundToInt() / TENTHS.toDouble()) }
                }
                if (noticesWarmth(world)) {
                    SurroundingsSlider(
                        SheetTexts.temperature(spoken),
                        SheetTexts.celsius(spoken, surroundings.celsius.roundToInt()),
                        WorldTags.TEMPERATURE,
                        surroundings.celsius.toFloat(),
                        TEMPERATURES,
                        inputs,
                    ) { SessionInput.ChangeTemperature(it.roundToInt().toDouble()) }
                }
            }
        }
    }
}

@Composable
private fun SurroundingsSlider(
    title: String,
    valueWords: String,
    tag: String,
    value: Float,
    range: ClosedFloatingPointRange<Float>,
    inputs: FrameThrottledInput,
    inputOf: (Float) -> SessionInput,
) {
    Text("$title: $valueWords", style = TextStyles.body)
    Slider(
        value.coerceIn(range),
        SliderWords(title, valueWords, WorldTags.surroundings(tag)),
        range = range,
        onSettle = inputs::flush,
    ) { inputs.send(inputOf(it)) }
}

private fun lightWords(light: Double): Label = when {
    light < DIM -> SheetTexts::lightDark
    light < BRIGHT -> SheetTexts::lightDim
    light < DAYLIGHT -> SheetTexts::lightBright
    else -> SheetTexts::lightDay
}

/** The limits of the words for brightness, in the units of [robotran.world.Light]. */
private const val DIM = 0.1
private const val BRIGHT = 0.8
private const val DAYLIGHT = 1.6
private const val MAX_LIGHT = 3f
private const val TENTHS = 10
private val TEMPERATURES = WorldLimits.MINIMUM_TEMPERATURE.toFloat()..WorldLimits.MAXIMUM_TEMPERATURE.toFloat()
private val PANEL_WIDTH = 280.dp
