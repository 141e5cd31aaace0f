package robotran.ui.worldedit

import org.jetbrains.compose.resources.StringResource
import robotran.ui.resources.*
import robotran.world.GoalCondition
import robotran.worldediting.GoalFieldName

/** The short title of a goal. */
internal fun goalTitle(condition: GoalCondition): StringResource = when (condition) {
    is GoalCondition.Reach -> Res.string.worldedit_goal_reach
    is GoalCondition.StayOut -> Res.string.worldedit_goal_stay_out
    is GoalCondition.StayIn -> Res.string.worldedit_goal_stay_in
    is GoalCondition.NeverTouch -> Res.string.worldedit_goal_never_touch
    is GoalCondition.DrawTemplate -> Res.string.worldedit_goal_draw_template
    is GoalCondition.InkLength -> Res.string.worldedit_goal_ink_length
    is GoalCondition.FollowLine -> Res.string.worldedit_goal_follow_line
    is GoalCondition.EndWithin -> Res.string.worldedit_goal_end_within
    is GoalCondition.ShowOnDisplay -> Res.string.worldedit_goal_show
    is GoalCondition.PlaySound -> Res.string.worldedit_goal_sound
    is GoalCondition.InOrder -> Res.string.worldedit_goal_in_order
    is GoalCondition.All -> Res.string.worldedit_goal_all
    is GoalCondition.AnyOf -> Res.string.worldedit_goal_any_of
}

/**
 * The labels of a goal's property in a form.
 *
 * @property tag its test tag.
 * @property switchLabel the label of the switch that enables the property; [switchTag] is its test tag.
 */
internal class GoalFieldWords(
    name: String,
    val label: StringResource,
    val switchLabel: StringResource = label,
    switchName: String = "has-$name",
) {
    val tag: String = "field-$name"
    val switchTag: String = "field-$switchName"
}

internal fun wordsFor(field: GoalFieldName): GoalFieldWords = when (field) {
    GoalFieldName.WHOLE -> GoalFieldWords("whole", Res.string.worldedit_whole)
    GoalFieldName.STAYS -> GoalFieldWords("stays", Res.string.worldedit_stays)

    GoalFieldName.WITHIN -> GoalFieldWords(
        "seconds",
        Res.string.worldedit_seconds,
        Res.string.worldedit_within,
        "within",
    )

    GoalFieldName.TOUCH_KINDS -> GoalFieldWords("touch", Res.string.worldedit_touch_what)
    GoalFieldName.TOLERANCE -> GoalFieldWords("tolerance", Res.string.worldedit_tolerance)
    GoalFieldName.COVERAGE -> GoalFieldWords("coverage", Res.string.worldedit_coverage)
    GoalFieldName.EXCESS -> GoalFieldWords("excess", Res.string.worldedit_excess)
    GoalFieldName.MIN_LENGTH -> GoalFieldWords("least", Res.string.worldedit_length, Res.string.worldedit_at_least)
    GoalFieldName.MAX_LENGTH -> GoalFieldWords("most", Res.string.worldedit_length, Res.string.worldedit_at_most)
    GoalFieldName.LINE -> GoalFieldWords("line", Res.string.worldedit_line)
    GoalFieldName.LAPS -> GoalFieldWords("laps", Res.string.worldedit_laps)
    GoalFieldName.SECONDS -> GoalFieldWords("seconds", Res.string.worldedit_seconds)
    GoalFieldName.TEXT -> GoalFieldWords("text", Res.string.worldedit_text)
    GoalFieldName.TIMES -> GoalFieldWords("times", Res.string.worldedit_times, Res.string.worldedit_counted)
    GoalFieldName.LOWEST_TONE -> GoalFieldWords("lowest", Res.string.worldedit_pitch, Res.string.worldedit_lowest)
    GoalFieldName.HIGHEST_TONE -> GoalFieldWords("highest", Res.string.worldedit_pitch, Res.string.worldedit_highest)
}
