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
import robotran.ui.resources.worldedit_pitch
import robotran.ui.resources.worldedit_says
import robotran.ui.resources.worldedit_says_hint
import robotran.ui.resources.worldedit_seconds
import robotran.ui.resources.worldedit_stays
import robotran.ui.resources.worldedit_text
import robotran.ui.resources.worldedit_times
import robotran.ui.resources.worldedit_tolerance
import robotran.ui.resources.worldedit_touch_what
import robotran.ui.resources.worldedit_who
import robotran.ui.resources.worldedit_whole
import robotran.ui.resources.worldedit_within
import robotran.ui.settings.SwitchRow
import robotran.world.Goal
import robotran.world.MarkFigure
import robotran.world.TouchKind
import robotran.world.WorldLimits
import robotran.worldediting.Edit
import robotran.worldediting.Piece
import robotran.worldediting.Thing
import robotran.worldediting.ThingKind
import robotran.worldediting.freeName
import robotran.worldediting.isGroup
import robotran.worldediting.name
import robotran.worldediting.named
import robotran.worldediting.piece
import robotran.worldediting.region
import robotran.worldediting.saying
import robotran.worldediting.who
import robotran.worldediting.withWho

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
private fun WholeField(whole: Boolean, onChange: (Boolean) -> Unit) =
    SwitchRow(stringResource(Res.string.worldedit_whole), whole, "field-whole", onChange)

/** Up to a second, or at any time. */
@Composable
private fun WithinField(sender: GoalSender, within: Int?, onChange: (Int?) -> Unit) {
    SwitchRow(stringResource(Res.string.worldedit_within), within != null, "field-within") {
        sender.settle()
        onChange(if (it) sender.making.world.timeLimit else null)
        sender.settle()
    }
    if (within != null) SecondsField(sender, within, onChange)
}

@Composable
private fun SecondsField(sender: GoalSender, seconds: Int, onChange: (Int) -> Unit) = NumberRow(
    stringResource(Res.string.worldedit_seconds), seconds.toDouble(), 1.0..WorldLimits.MAXIMUM_SECONDS.toDouble(), "field-seconds",
    { onChange(it.toInt()) }, sender::settle, step = 5.0, unit = "s", isWhole = true, slider = 1f..120f,
)

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
private fun ToleranceField(sender: GoalSender, tolerance: Double, onChange: (Double) -> Unit) = NumberRow(
    stringResource(Res.string.worldedit_tolerance), tolerance, WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_TOLERANCE,
    "field-tolerance", onChange, sender::settle, step = 0.5, unit = "cm", slider = 0.5f..10f,
)

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

@Composable
private fun ToneField(sender: GoalSender, title: StringResource, hertz: Int?, tag: String, usual: Int, onChange: (Int?) -> Unit) {
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

/** Robots, and where a place is meant blocks too. */
@Composable
private fun WhoField(sender: GoalSender, goal: Goal) {
    val world = sender.making.world
    val robots = world.robots.indices.drop(1).map { Thing(ThingKind.ROBOT, it) }
    val blocks = if (goal.region != null) world.blocks.indices.map { Thing(ThingKind.BLOCK, it) } else emptyList()
    val first = Thing(ThingKind.ROBOT, 0)
    val choices = (listOf(first) + robots + blocks).map { it to thingInWords(world, it) }
    val shown = goal.who ?: choices.first().second
    MenuRow(stringResource(Res.string.worldedit_who), choices, shown, "field-who") { thing ->
        if (thing == first) {
            sender.once(goal.withWho(null))
        } else {
            sender.making.nameAnd(thing, choices) { name -> Edit.Change(sender.thing, Piece.OfGoal(goal.withWho(name))) }
        }
    }
}

/**
 * Gives [thing] its word from [words] for a name if it has none, since goals know things by their names, and goes on with that as one
 * step.
 */
private fun Making.nameAnd(thing: Thing, words: List<Pair<Thing, String>>, next: (String) -> Edit) {
    val piece = world.piece(thing) ?: return
    val known = piece.name
    if (known != null) return makeAtOnce(next(known))
    val name = world.freeName(words.first { it.first == thing }.second.take(WorldLimits.MAXIMUM_NAME_CHARACTERS))
    makeAtOnce(Edit.Together(listOf(Edit.Change(thing, piece.named(name)), next(name))))
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
