package robotran.ui.drawer

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.brick.log.CallGroup
import robotran.brick.log.CallLogFilter
import robotran.brick.log.CallOutcome
import robotran.brick.log.LoggedCall
import robotran.ui.empty.EmptyPicture
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.BrickLabels
import robotran.ui.texts.NxtTexts
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.state.LogState

/** All calls of the brick so far, newest last, to search, filter, copy and save. */
@Composable
internal fun LogView(state: LogState, onEvent: (RunEvent) -> Unit, modifier: Modifier = Modifier) {
    if (state.total == 0L) {
        return EmptyDrawer(BrickLabels.of(state.kind).noCalls, EmptyPicture.LINES, modifier)
    }
    Column(modifier.padding(horizontal = 12.dp)) {
        LogTools(state, onEvent)
        if (state.entries.isEmpty() && state.isComplete) {
            EmptyDrawer(RunTexts::logNone, EmptyPicture.LINES, Modifier.fillMaxWidth())
        } else {
            LogEntries(state.entries, Modifier.weight(1f).fillMaxWidth())
        }
    }
}

@Composable
private fun LogTools(state: LogState, onEvent: (RunEvent) -> Unit) {
    val filter = state.filter
    val search = RunTexts.logSearch(spoken)
    val scroll = rememberScrollState()
    Row(
        Modifier
            .fillMaxWidth()
            .scrollHint(scroll, Orientation.Horizontal)
            .horizontalScroll(scroll)
            .padding(vertical = 4.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        TextField(
            filter.text,
            { onEvent(RunEvent.LogFiltered(filter.copy(text = it))) },
            Modifier.testTag(RunTags.LOG_SEARCH).widthIn(min = 160.dp, max = 220.dp).semantics {
                contentDescription = search
            },
            extras = FieldExtras(placeholder = search),
        )
        Text(
            RunTexts.logCount(spoken, state.entries.size, state.total.toInt()),
            Modifier.testTag(RunTags.LOG_COUNT),
            TextStyles.small,
            color = LocalRobotranColours.current.quiet,
            maxLines = 1,
        )
        Button(RunTexts.logCopy(spoken), RunTags.LOG_COPY, ButtonKind.TOOL) { onEvent(RunEvent.LogCopied) }
        Button(RunTexts.logSave(spoken), RunTags.LOG_SAVE, ButtonKind.TOOL) { onEvent(RunEvent.LogSaved) }
        Chip(RunTexts.logProgram(spoken), filter.sourceLines != null, RunTags.LOG_PROGRAM) {
            onEvent(
                RunEvent.LogFiltered(
                    filter.copy(
                        sourceLines = if (filter.sourceLines == null) {
                            1..Int.MAX_VALUE
                        } else {
                            null
                        },
                    ),
                ),
            )
        }
        Chip(RunTexts.logTroubled(spoken), filter.onlyReported, RunTags.LOG_TROUBLED) {
            onEvent(RunEvent.LogFiltered(filter.copy(onlyReported = !filter.onlyReported)))
        }
        for (group in state.kind.callGroups) {
            val only = filter.groups.size < CallGroup.entries.size && group in filter.groups
            Chip(group.word(spoken), only, RunTags.log(group)) {
                onEvent(RunEvent.LogFiltered(filter.switched(group)))
            }
        }
    }
}

/** If all groups are selected, selects only [group]; otherwise toggles it. */
private fun CallLogFilter.switched(group: CallGroup): CallLogFilter {
    val all = CallGroup.entries.toSet()
    val now = if (groups == all) emptySet() else groups
    val next = if (group in now) now - group else now + group
    return copy(groups = next.ifEmpty { all })
}

@Composable
private fun LogEntries(entries: List<LoggedCall>, modifier: Modifier) {
    val list = rememberLazyListState()
    FollowEnd(list, entries.size)
    BoxWithConstraints(modifier) {
        val showsCode = maxWidth / LocalDensity.current.fontScale >= 560.dp
        val style = codeStyle().copy(fontSize = TextSizes.SMALL, lineHeight = LineHeights.SMALL)
        val hint = Modifier.scrollHint(list)
        LazyColumn(hint.fillMaxSize().testTag(RunTags.LOG), list) {
            items(entries.size) { LogRow(entries[it], showsCode, style) }
        }
    }
}

/** Scrolls to new entries while the list is at its end. */
@Composable
private fun FollowEnd(list: LazyListState, size: Int) {
    val isAtEnd by remember(list) { derivedStateOf { !list.canScrollForward } }
    val wasAtEnd = isAtEnd
    LaunchedEffect(size) { if (wasAtEnd && size > 0) list.requestScrollToItem(size - 1) }
}

@Composable
private fun LogRow(entry: LoggedCall, showsCode: Boolean, style: TextStyle) {
    val colours = LocalRobotranColours.current
    val troubled = entry.outcome != CallOutcome.DONE
    val scale = LocalDensity.current.fontScale
    Row(
        Modifier.fillMaxWidth().padding(vertical = 2.dp).semantics(mergeDescendants = true) {},
        Arrangement.spacedBy(12.dp),
    ) {
        Text(
            "${entry.milliseconds}",
            Modifier.width(64.dp * scale),
            style.copy(color = colours.quiet, textAlign = TextAlign.End),
        )
        Text(
            if (troubled) "! ${entry.meaning}" else entry.meaning,
            Modifier.weight(1.4f),
            if (troubled) style.copy(color = colours.error) else style,
        )
        if (showsCode) {
            val quiet = style.copy(color = colours.quiet)
            Text(callText(entry), Modifier.weight(1f), quiet, maxLines = 1, overflow = TextOverflow.Ellipsis)
        }
        Text(
            when {
                entry.isByLibrary -> NxtTexts.runLogLibrary(spoken)
                entry.sourceLine == 0 -> RunTexts.logFirmware(spoken)
                else -> RunTexts.logLine(spoken, entry.sourceLine)
            },
            Modifier.width(84.dp * scale),
            style.copy(color = colours.quiet),
            maxLines = 1,
        )
    }
}

/** The address and the arguments, as in a saved log. */
private fun callText(entry: LoggedCall): String = entry.callText

private val CallGroup.word: Label
    get() = when (this) {
        CallGroup.SENSORS -> RunTexts::logGroupSensors
        CallGroup.MOTORS -> RunTexts::logGroupMotors
        CallGroup.BUTTONS -> RunTexts::logGroupButtons
        CallGroup.DISPLAY -> RunTexts::logGroupDisplay
        CallGroup.SOUND -> RunTexts::logGroupSound
        CallGroup.POWER -> RunTexts::logGroupPower
        CallGroup.INFRARED -> RunTexts::logGroupInfrared
        CallGroup.TIMER -> RunTexts::logGroupTimer
        CallGroup.BLUETOOTH -> NxtTexts::runLogGroupBluetooth
        CallGroup.SYSTEM -> NxtTexts::runLogGroupSystem
        CallGroup.UNKNOWN -> RunTexts::logGroupUnknown
    }
