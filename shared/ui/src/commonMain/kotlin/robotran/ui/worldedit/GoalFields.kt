package robotran.ui.worldedit

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.worldedit_at_least
import robotran.ui.resources.worldedit_at_most
import robotran.ui.resources.worldedit_coverage
import robotran.ui.resources.worldedit_excess
import robotran.ui.resources.worldedit_group_help
import robotran.ui.resources.worldedit_highest
import robotran.ui.resources.worldedit_kind_barriers
import robotran.ui.resources.worldedit_kind_blocks
import robotran.ui.resources.worldedit_kind_robots
import robotran.ui.resources.worldedit_kind_walls
import robotran.ui.resources.worldedit_laps
import robotran.ui.resources.worldedit_length
import robotran.ui.resources.worldedit_line
import robotran.ui.resources.worldedit_lowest
import robotran.ui.resources.worldedit_says
import robotran.ui.resources.worldedit_says_hint
import robotran.ui.resources.worldedit_stays
import robotran.ui.resources.worldedit_text
import robotran.ui.resources.worldedit_times
import robotran.ui.resources.worldedit_touch_what
import robotran.ui.settings.SwitchRow
import robotran.world.Goal
import robotran.world.MarkFigure
import robotran.world.TouchKind
import robotran.world.WorldLimits
import robotran.worldediting.Edit
import robotran.worldediting.Piece
import robotran.worldediting.Thing
import robotran.worldediting.ThingKind
import robotran.worldediting.isGroup
import robotran.worldediting.name
import robotran.worldediting.piece
import robotran.worldediting.region
import robotran.worldediting.saying

/** All that can be said of a goal. */
@Composable
internal fun GoalFields(making: Making, thing: Thing, piece: Piece.OfGoal) {
    val goal = piece.goal
    val sender = GoalSender(making, thing)
    TextRow(
        stringResource(Res.string.worldedit_says), goal.says.orEmpty(), WorldLimits.MAXIMUM_SENTENCE_CHARACTERS, "field-says",
        { sender.change(goal.saying(it.takeIf(String::isNotBlank))) }, making::settle,
        mayBeBlank = true, hint = stringResource(Res.string.worldedit_says_hint),
    )
    when (goal) {
        is Goal.Reach -> ReachFields(sender, goal)

        is Goal.StayOut -> WholeField(goal.whole) { sender.once(goal.copy(whole = it)) }

        is Goal.StayIn -> WholeField(goal.whole) { sender.once(goal.copy(whole = it)) }

        is Goal.NeverTouch -> TouchFields(sender, goal)

        is Goal.DrawTemplate -> TemplateFields(sender, goal)

        is Goal.InkLength -> InkFields(sender, goal)

        is Goal.FollowLine -> LineFields(sender, goal)

        is Goal.EndWithin -> SecondsField(sender, goal.seconds) { sender.change(goal.copy(seconds = it)) }

        is Goal.ShowOnDisplay -> TextRow(
            stringResource(Res.string.worldedit_text), goal.text, WorldLimits.MAXIMUM_DISPLAY_CHARACTERS, "field-text",
            { sender.change(goal.copy(text = it)) }, making::settle,
        )

        is Goal.PlaySound -> SoundFields(sender, goal)

        is Goal.InOrder, is Goal.All, is Goal.AnyOf -> Remark(stringResource(Res.string.worldedit_group_help))
    }
    if (!goal.isGroup && goal !is Goal.DrawTemplate && goal !is Goal.InkLength) WhoField(sender, goal)
    if (goal.region != null) FormFields(making, thing, piece)
}

/** Says what becomes of a goal. */
internal class GoalSender(val making: Making, val thing: Thing) {
    fun change(goal: Goal) = making.change(thing, Piece.OfGoal(goal))

    fun once(goal: Goal) = making.changeAtOnce(thing, Piece.OfGoal(goal))

    fun settle() = making.settle()
}

@Composable
private fun ReachFields(sender: GoalSender, goal: Goal.Reach) = Column(Modifier.fillMaxWidth()) {
    WholeField(goal.whole) { sender.once(goal.copy(whole = it)) }
    SwitchRow(stringResource(Res.string.worldedit_stays), goal.stays, "field-stays") { sender.once(goal.copy(stays = it)) }
    WithinField(sender, goal.within) { sender.change(goal.copy(within = it)) }
}

@Composable
private fun TouchFields(sender: GoalSender, goal: Goal.NeverTouch) = Column(Modifier.fillMaxWidth()) {
    RowHeading(stringResource(Res.string.worldedit_touch_what))
    for (kind in TouchKind.entries) {
        SwitchRow(stringResource(touchWord(kind)), kind in goal.what, "touch-${kind.name.lowercase()}") { on ->
            sender.once(goal.copy(what = if (on) goal.what + kind else goal.what - kind))
        }
    }
}

@Composable
private fun TemplateFields(sender: GoalSender, goal: Goal.DrawTemplate) = Column(Modifier.fillMaxWidth()) {
    ToleranceField(sender, goal.tolerance) { sender.change(goal.copy(tolerance = it)) }
    NumberRow(
        stringResource(Res.string.worldedit_coverage), goal.coverage * PERCENT, 0.0..PERCENT, "field-coverage",
        { sender.change(goal.copy(coverage = it / PERCENT)) }, sender::settle, step = 5.0, unit = "%", slider = 0f..100f,
    )
    NumberRow(
        stringResource(Res.string.worldedit_excess), goal.excess * PERCENT, 0.0..WorldLimits.MAXIMUM_EXCESS * PERCENT, "field-excess",
        { sender.change(goal.copy(excess = it / PERCENT)) }, sender::settle, step = 5.0, unit = "%", slider = 0f..100f,
    )
}

@Composable
private fun InkFields(sender: GoalSender, goal: Goal.InkLength) = Column(Modifier.fillMaxWidth()) {
    val range = 0.0..WorldLimits.MAXIMUM_INK
    SwitchRow(stringResource(Res.string.worldedit_at_least), goal.atLeast != null, "field-has-least") { on ->
        sender.once(goal.copy(atLeast = if (on) minOf(USUAL_INK, goal.atMost ?: USUAL_INK) else null))
    }
    goal.atLeast?.let { least ->
        NumberRow(
            stringResource(Res.string.worldedit_length), least, range, "field-least",
            { sender.change(goal.copy(atLeast = it)) }, sender::settle, step = 10.0, unit = "cm",
        )
    }
    SwitchRow(stringResource(Res.string.worldedit_at_most), goal.atMost != null, "field-has-most") { on ->
        sender.once(goal.copy(atMost = if (on) maxOf(USUAL_INK, goal.atLeast ?: USUAL_INK) else null))
    }
    goal.atMost?.let { most ->
        NumberRow(
            stringResource(Res.string.worldedit_length), most, range, "field-most",
            { sender.change(goal.copy(atMost = it)) }, sender::settle, step = 10.0, unit = "cm",
        )
    }
}

@Composable
private fun LineFields(sender: GoalSender, goal: Goal.FollowLine) = Column(Modifier.fillMaxWidth()) {
    val world = sender.making.world
    val lines = world.marks.indices.filter { world.marks[it].figure is MarkFigure.Line }.map { Thing(ThingKind.MARK, it) }
    val choices = lines.map { it to thingInWords(world, it) }
    MenuRow(stringResource(Res.string.worldedit_line), choices, goal.line, "field-line") { line ->
        sender.making.nameAnd(line, choices) { name -> Edit.Change(sender.thing, Piece.OfGoal(goal.copy(line = name))) }
    }
    NumberRow(
        stringResource(Res.string.worldedit_laps), goal.laps, WorldLimits.MINIMUM_LAPS..WorldLimits.MAXIMUM_LAPS, "field-laps",
        { sender.change(goal.copy(laps = it)) }, sender::settle, slider = 1f..10f,
    )
    ToleranceField(sender, goal.tolerance) { sender.change(goal.copy(tolerance = it)) }
    WithinField(sender, goal.within) { sender.change(goal.copy(within = it)) }
}

@Composable
private fun SoundFields(sender: GoalSender, goal: Goal.PlaySound) = Column(Modifier.fillMaxWidth()) {
    NumberRow(
        stringResource(Res.string.worldedit_times), goal.times.toDouble(), 1.0..WorldLimits.MAXIMUM_SOUNDS.toDouble(), "field-times",
        { sender.change(goal.copy(times = it.toInt())) }, sender::settle, isWhole = true,
    )
    ToneField(sender, Res.string.worldedit_lowest, goal.lowest, "lowest", minOf(USUAL_TONE, goal.highest ?: USUAL_TONE)) {
        sender.change(goal.copy(lowest = it))
    }
    ToneField(sender, Res.string.worldedit_highest, goal.highest, "highest", maxOf(USUAL_TONE, goal.lowest ?: USUAL_TONE)) {
        sender.change(goal.copy(highest = it))
    }
}

private fun touchWord(kind: TouchKind): StringResource = when (kind) {
    TouchKind.WALLS -> Res.string.worldedit_kind_walls
    TouchKind.BARRIERS -> Res.string.worldedit_kind_barriers
    TouchKind.BLOCKS -> Res.string.worldedit_kind_blocks
    TouchKind.ROBOTS -> Res.string.worldedit_kind_robots
}

private const val PERCENT = 100.0
private const val USUAL_INK = 40.0
private const val USUAL_TONE = 440
