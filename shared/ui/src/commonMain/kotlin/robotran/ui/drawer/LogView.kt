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
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
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
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallGroup
import robotran.brick.log.CallLogFilter
import robotran.brick.log.CallOutcome
import robotran.brick.log.LoggedCall
import robotran.ui.empty.EmptyPicture
import robotran.ui.parts.scrollHint
import robotran.ui.resources.*
import robotran.ui.runbar.Chip
import robotran.ui.theme.LineHeights
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.ui.theme.codeStyle
import robotran.ui.theme.focusRing
import robotran.workshop.event.RunEvent
import robotran.workshop.state.LogState

/** All calls of the brick so far, newest last, to search, filter, copy and save. */
@Composable
internal fun LogView(state: LogState, onEvent: (RunEvent) -> Unit, modifier: Modifier = Modifier) {
    if (state.total == 0L) {
        val words = if (state.kind == BrickKind.RCX) Res.string.run_log_empty else Res.string.run_log_empty_calls
        return EmptyDrawer(words, EmptyPicture.LINES, modifier)
    }
    Column(modifier.padding(horizontal = 12.dp)) {
        LogTools(state, onEvent)
        if (state.entries.isEmpty() && state.isComplete) {
            EmptyDrawer(Res.string.run_log_none, EmptyPicture.LINES, Modifier.fillMaxWidth())
        } else {
            LogEntries(state.entries, Modifier.weight(1f).fillMaxWidth())
        }
    }
}

@Composable
private fun LogTools(state: LogState, onEvent: (RunEvent) -> Unit) {
    val filter = state.filter
    val search = stringResource(Res.string.run_log_search)
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Row(
        Modifier
            .fillMaxWidth()
            .scrollHint(scroll, Orientation.Horizontal, colours.pane, colours.onPane)
            .horizontalScroll(scroll)
            .padding(vertical = 4.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        OutlinedTextField(
            filter.text,
            { onEvent(RunEvent.LogFiltered(filter.copy(text = it))) },
            Modifier.testTag("log-search").widthIn(min = 160.dp, max = 220.dp).semantics {
                contentDescription = search
            },
            placeholder = { Text(search, maxLines = 1) },
            singleLine = true,
        )
        Text(
            stringResource(Res.string.run_log_count, state.entries.size, state.total.toInt()),
            Modifier.testTag("log-count"),
            color = LocalRobotranColours.current.quiet,
            fontSize = TextSizes.SMALL,
            maxLines = 1,
        )
        ToolButton(Res.string.run_log_copy, "log-copy") { onEvent(RunEvent.LogCopied) }
        ToolButton(Res.string.run_log_save, "log-save") { onEvent(RunEvent.LogSaved) }
        Chip(stringResource(Res.string.run_log_program), filter.sourceLines != null, "log-program") {
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
        Chip(stringResource(Res.string.run_log_troubled), filter.onlyReported, "log-troubled") {
            onEvent(RunEvent.LogFiltered(filter.copy(onlyReported = !filter.onlyReported)))
        }
        for (group in CallGroup.of(state.kind)) {
            val only = filter.groups.size < CallGroup.entries.size && group in filter.groups
            Chip(stringResource(group.word), only, "log-${group.name.lowercase()}") {
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
private fun ToolButton(name: StringResource, tag: String, onClick: () -> Unit) {
    TextButton(onClick, Modifier.testTag(tag).focusRing()) {
        Text(
            stringResource(name),
            color = LocalRobotranColours.current.onPane,
            fontSize = TextSizes.COMPACT,
            maxLines = 1,
        )
    }
}

@Composable
private fun LogEntries(entries: List<LoggedCall>, modifier: Modifier) {
    val list = rememberLazyListState()
    val colours = LocalRobotranColours.current
    FollowEnd(list, entries.size)
    BoxWithConstraints(modifier) {
        val showsCode = maxWidth / LocalDensity.current.fontScale >= 560.dp
        val style = codeStyle().copy(fontSize = TextSizes.SMALL, lineHeight = LineHeights.SMALL)
        val hint = Modifier.scrollHint(list, Orientation.Vertical, colours.pane, colours.onPane)
        LazyColumn(hint.fillMaxSize().testTag("log"), list) {
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
            style = style.copy(color = colours.quiet, textAlign = TextAlign.End),
        )
        Text(
            if (troubled) "! ${entry.meaning}" else entry.meaning,
            Modifier.weight(1.4f),
            style = if (troubled) style.copy(color = colours.error) else style,
        )
        if (showsCode) {
            val quiet = style.copy(color = colours.quiet)
            Text(callText(entry), Modifier.weight(1f), style = quiet, maxLines = 1, overflow = TextOverflow.Ellipsis)
        }
        Text(
            when {
                entry.isByLibrary -> stringResource(Res.string.run_log_library)
                entry.sourceLine == 0 -> stringResource(Res.string.run_log_firmware)
                else -> stringResource(Res.string.run_log_line, entry.sourceLine)
            },
            Modifier.width(84.dp * scale),
            style = style.copy(color = colours.quiet),
            maxLines = 1,
        )
    }
}

/** The address and the arguments, as in a saved log. */
private fun callText(entry: LoggedCall): String = entry.callText

private val CallGroup.word: StringResource
    get() = when (this) {
        CallGroup.SENSORS -> Res.string.run_log_group_sensors
        CallGroup.MOTORS -> Res.string.run_log_group_motors
        CallGroup.BUTTONS -> Res.string.run_log_group_buttons
        CallGroup.DISPLAY -> Res.string.run_log_group_display
        CallGroup.SOUND -> Res.string.run_log_group_sound
        CallGroup.POWER -> Res.string.run_log_group_power
        CallGroup.INFRARED -> Res.string.run_log_group_infrared
        CallGroup.TIMER -> Res.string.run_log_group_timer
        CallGroup.BLUETOOTH -> Res.string.run_log_group_bluetooth
        CallGroup.SYSTEM -> Res.string.run_log_group_system
        CallGroup.UNKNOWN -> Res.string.run_log_group_unknown
    }
