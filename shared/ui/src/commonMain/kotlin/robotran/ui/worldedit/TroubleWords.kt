package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.language.LocalLanguage
import robotran.ui.resources.Res
import robotran.ui.resources.worldedit_kind_barriers
import robotran.ui.resources.worldedit_kind_blocks
import robotran.ui.resources.worldedit_kind_goals
import robotran.ui.resources.worldedit_kind_lamps
import robotran.ui.resources.worldedit_kind_marks
import robotran.ui.resources.worldedit_kind_robots
import robotran.ui.resources.worldedit_kind_strokes
import robotran.ui.resources.worldedit_kind_walls
import robotran.ui.resources.worldedit_refusal_corners
import robotran.ui.resources.worldedit_refusal_deep
import robotran.ui.resources.worldedit_refusal_far
import robotran.ui.resources.worldedit_refusal_last_robot
import robotran.ui.resources.worldedit_refusal_name
import robotran.ui.resources.worldedit_refusal_needs_line
import robotran.ui.resources.worldedit_refusal_needs_template
import robotran.ui.resources.worldedit_refusal_points
import robotran.ui.resources.worldedit_refusal_range
import robotran.ui.resources.worldedit_refusal_same_place
import robotran.ui.resources.worldedit_refusal_size
import robotran.ui.resources.worldedit_refusal_text
import robotran.ui.resources.worldedit_refusal_too_many
import robotran.ui.resources.worldedit_trouble_in_the_way
import robotran.ui.resources.worldedit_trouble_no_line
import robotran.ui.resources.worldedit_trouble_no_template
import robotran.ui.resources.worldedit_trouble_nobody
import robotran.ui.resources.worldedit_trouble_off_paper
import robotran.ui.resources.worldedit_trouble_tangled
import robotran.world.World
import robotran.worldediting.Refusal
import robotran.worldediting.ThingKind
import robotran.worldediting.Trouble
import robotran.worldediting.most

/** What has to be mended, as a sentence. */
@Composable
internal fun troubleInWords(world: World, trouble: Trouble): String = when (trouble) {
    is Trouble.InTheWay -> stringResource(
        Res.string.worldedit_trouble_in_the_way, thingInWords(world, trouble.thing), thingInWords(world, trouble.other),
    )

    is Trouble.OffPaper -> stringResource(Res.string.worldedit_trouble_off_paper, thingInWords(world, trouble.thing))

    is Trouble.Tangled -> stringResource(Res.string.worldedit_trouble_tangled, thingInWords(world, trouble.thing))

    is Trouble.NobodyThere -> stringResource(Res.string.worldedit_trouble_nobody, trouble.name)

    is Trouble.NoSuchLine -> stringResource(Res.string.worldedit_trouble_no_line, trouble.name)

    is Trouble.NothingToTrace -> stringResource(Res.string.worldedit_trouble_no_template)

    is Trouble.Refused -> trouble.message(LocalLanguage.current)
}

/** Why something was not done, as a sentence. */
@Composable
internal fun refusalInWords(refusal: Refusal): String = when (refusal) {
    is Refusal.TooMany -> stringResource(Res.string.worldedit_refusal_too_many, stringResource(kindsWord(refusal.kind)), most(refusal.kind))
    Refusal.TooManyPoints -> stringResource(Res.string.worldedit_refusal_points)
    Refusal.TooFar -> stringResource(Res.string.worldedit_refusal_far)
    Refusal.NoSuchSize -> stringResource(Res.string.worldedit_refusal_size)
    Refusal.OutOfRange -> stringResource(Res.string.worldedit_refusal_range)
    Refusal.TooFewCorners -> stringResource(Res.string.worldedit_refusal_corners)
    Refusal.SamePlace -> stringResource(Res.string.worldedit_refusal_same_place)
    is Refusal.NameTaken -> stringResource(Res.string.worldedit_refusal_name, refusal.name)
    Refusal.NoSuchText -> stringResource(Res.string.worldedit_refusal_text)
    Refusal.LastRobot -> stringResource(Res.string.worldedit_refusal_last_robot)
    Refusal.NeedsLine -> stringResource(Res.string.worldedit_refusal_needs_line)
    Refusal.NeedsTemplate -> stringResource(Res.string.worldedit_refusal_needs_template)
    Refusal.TooDeep -> stringResource(Res.string.worldedit_refusal_deep)
}

/** All things of a kind together. */
internal fun kindsWord(kind: ThingKind): StringResource = when (kind) {
    ThingKind.MARK -> Res.string.worldedit_kind_marks
    ThingKind.STROKE -> Res.string.worldedit_kind_strokes
    ThingKind.GOAL -> Res.string.worldedit_kind_goals
    ThingKind.WALL -> Res.string.worldedit_kind_walls
    ThingKind.BARRIER -> Res.string.worldedit_kind_barriers
    ThingKind.BLOCK -> Res.string.worldedit_kind_blocks
    ThingKind.ROBOT -> Res.string.worldedit_kind_robots
    ThingKind.LAMP -> Res.string.worldedit_kind_lamps
}
