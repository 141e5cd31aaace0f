package robotran.ui.drawer

import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.controls.PowerUnit
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.MeasuringUnit
import robotran.nxt.hardware.SonarDevice
import robotran.runcontrol.ChartLane
import robotran.runcontrol.ChartLine
import robotran.ui.empty.EmptyPicture
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.NxtTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.state.RunPaneState

/** Sensors and motors over time, one lane each, with their values at the current or touched time. */
@Composable
internal fun ChartView(state: RunPaneState, onEvent: (RunEvent) -> Unit, modifier: Modifier = Modifier) {
    if (state.untouched || state.drawer.chart.lines.isEmpty()) {
        return EmptyDrawer(RunTexts::chartEmpty, EmptyPicture.CURVE, modifier)
    }
    var zoom by rememberSaveable { mutableIntStateOf(0) }
    var touched by rememberSaveable { mutableStateOf<Long?>(null) }
    val chart = state.drawer.chart
    val shown = chart.lines.filter { it.lane !in chart.hidden }
    val window = ChartWindow.around(state.time, state.length, zoom)
    Column(modifier.padding(horizontal = 12.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            Row(Modifier.weight(1f).horizontalScroll(rememberScrollState()), Arrangement.spacedBy(8.dp)) {
                for (line in chart.lines) {
                    Chip(laneName(line.lane, state.brick.kind), line.lane !in chart.hidden, RunTags.lane(line.lane)) {
                        onEvent(RunEvent.LaneSwitched(line.lane))
                    }
                }
            }
            Zoom(zoom) { zoom = it }
        }
        if (shown.isEmpty()) {
            return EmptyDrawer(
                RunTexts::chartAllHidden,
                EmptyPicture.CURVE,
                Modifier.fillMaxWidth(),
            )
        }
        Column(Modifier.weight(1f).fillMaxWidth().verticalScroll(rememberScrollState())) {
            for (line in shown) {
                Lane(
                    laneName(line.lane, state.brick.kind),
                    line,
                    state.brick.kind,
                    window,
                    touched ?: state.time,
                    state.time,
                ) {
                    touched =
                        it
                }
            }
            Times(listOf(window.from, touched, window.until))
        }
    }
}

@Composable
private fun Zoom(zoom: Int, onZoom: (Int) -> Unit) {
    IconButton(
        RunIcons.LESS,
        RunTexts.chartCoarser(spoken),
        RunTags.CHART_COARSER,
        IconButtonKind.RUN,
        enabled = zoom > 0,
    ) {
        onZoom(zoom - 1)
    }
    IconButton(
        RunIcons.MORE,
        RunTexts.chartFiner(spoken),
        RunTags.CHART_FINER,
        IconButtonKind.RUN,
        enabled = zoom < MAX_ZOOM,
    ) { onZoom(zoom + 1) }
}

@Composable
private fun Times(times: List<Long?>) = Row(Modifier.fillMaxWidth(), Arrangement.SpaceBetween) {
    for (time in times) {
        Text(
            time?.let { "${secondsText(it)} s" }.orEmpty(),
            Modifier.testTag(RunTags.CHART_TIME),
            TextStyles.small,
            color = LocalRobotranColours.current.quiet,
        )
    }
}

@Composable
private fun laneName(lane: ChartLane, brick: BrickKind): String = when {
    lane.isMotor -> RunTexts.chartMotor(spoken, "${'A' + lane.port}")
    lane.isDegrees -> NxtTexts.runChartDegrees(spoken, "${'A' + lane.port}")
    lane == ChartLane.BATTERY -> NxtTexts.runChartBattery(spoken)
    else -> RunTexts.chartSensor(spoken, brick.inputLabel(lane.port + 1))
}

/**
 * The time range of the chart.
 *
 * @property from milliseconds.
 * @property until milliseconds, greater than [from].
 */
internal data class ChartWindow(val from: Long, val until: Long) {
    /** The position of [time], from 0 at the left end to 1 at the right. */
    fun shareOf(time: Long): Float = (time - from).toFloat() / (until - from)

    fun timeAt(share: Float): Long = from + ((until - from) * share.coerceIn(0f, 1f)).toLong()

    companion object {
        /** The range around [time] with [length] halved [zoom] times; at least [MIN]. */
        fun around(time: Long, length: Long, zoom: Int): ChartWindow {
            val whole = maxOf(length, MIN)
            val width = maxOf(MIN, whole shr zoom)
            val from = (time - width / 2).coerceIn(0, whole - width)
            return ChartWindow(from, from + width)
        }

        /** Milliseconds. */
        const val MIN = 500L
    }
}

/**
 * What the lane of [line] shows from bottom to top, always a range of some width: all values and, except for those of a
 * battery, 0. Where a sonar hears nothing, its line is at the top: 255 would make all distances look small.
 */
internal fun rangeOf(line: ChartLine, brick: BrickKind): IntRange {
    if (line.lane.isMotor) {
        val greatest = if (brick.powerUnit == PowerUnit.STEPS) MAX_POWER else PERCENT
        return -greatest..greatest
    }
    if (line.unit == MeasuringUnit.PERCENT) return 0..PERCENT
    val isBattery = line.unit == MeasuringUnit.MILLIVOLTS
    var min = if (isBattery) LOW_MILLIVOLTS else 0
    var greatest = if (isBattery) FULL_MILLIVOLTS else 1
    val nothing = if (line.unit == MeasuringUnit.CENTIMETRES) SonarDevice.NOTHING else Int.MAX_VALUE
    for (piece in 0..<line.size) {
        val values = line.range(piece) ?: continue
        min = minOf(min, values.first)
        greatest =
            maxOf(greatest, if (values.last < nothing) values.last else values.first.takeIf { it < nothing } ?: 0)
    }
    return min..greatest
}

private const val MAX_ZOOM = 8
private const val MAX_POWER = 8
private const val PERCENT = 100

/** What the battery of a driving NXT seldom leaves: a full one has 8 V. */
private const val LOW_MILLIVOLTS = 7_000
private const val FULL_MILLIVOLTS = 8_200
