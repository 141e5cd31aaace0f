package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.worldedit_pitch
import robotran.ui.resources.worldedit_seconds
import robotran.ui.resources.worldedit_tolerance
import robotran.ui.resources.worldedit_whole
import robotran.ui.resources.worldedit_within
import robotran.ui.settings.SwitchRow
import robotran.world.WorldLimits

/** Whether all of it has to be there, or just its middle. */
@Composable
internal fun WholeField(whole: Boolean, onChange: (Boolean) -> Unit) =
    SwitchRow(stringResource(Res.string.worldedit_whole), whole, "field-whole", onChange)

/** Up to a second, or at any time. */
@Composable
internal fun WithinField(sender: GoalSender, within: Int?, onChange: (Int?) -> Unit) {
    SwitchRow(stringResource(Res.string.worldedit_within), within != null, "field-within") {
        sender.settle()
        onChange(if (it) sender.making.world.timeLimit else null)
        sender.settle()
    }
    if (within != null) SecondsField(sender, within, onChange)
}

/** A time of the run. */
@Composable
internal fun SecondsField(sender: GoalSender, seconds: Int, onChange: (Int) -> Unit) = NumberRow(
    stringResource(Res.string.worldedit_seconds), seconds.toDouble(), 1.0..WorldLimits.MAXIMUM_SECONDS.toDouble(), "field-seconds",
    { onChange(it.toInt()) }, sender::settle, step = 5.0, unit = "s", isWhole = true, slider = 1f..120f,
)

/** How far beside a line still counts, in centimetres. */
@Composable
internal fun ToleranceField(sender: GoalSender, tolerance: Double, onChange: (Double) -> Unit) = NumberRow(
    stringResource(Res.string.worldedit_tolerance), tolerance, WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE,
    "field-tolerance", onChange, sender::settle, step = 0.5, unit = "cm", slider = 0.5f..10f,
)

/**
 * A pitch that sounds are held against, or none.
 *
 * @param usual what it is at first, in hertz.
 */
@Composable
internal fun ToneField(sender: GoalSender, title: StringResource, hertz: Int?, tag: String, usual: Int, onChange: (Int?) -> Unit) {
    SwitchRow(stringResource(title), hertz != null, "field-has-$tag") {
        sender.settle()
        onChange(if (it) usual else null)
        sender.settle()
    }
    if (hertz == null) return
    NumberRow(
        stringResource(Res.string.worldedit_pitch), hertz.toDouble(),
        WorldLimits.LOWEST_TONE.toDouble()..WorldLimits.HIGHEST_TONE.toDouble(),
        "field-$tag",
        { onChange(it.toInt()) }, sender::settle, step = 10.0, unit = "Hz", isWhole = true,
    )
}
