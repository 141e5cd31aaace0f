package robotran.ui.worldedit

import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.GoalCondition
import robotran.worldediting.GoalFieldName

/** The short title of a goal. */
internal fun goalTitle(condition: GoalCondition): Label = when (condition) {
    is GoalCondition.Reach -> WorldEditorTexts::goalReach
    is GoalCondition.StayOut -> WorldEditorTexts::goalStayOut
    is GoalCondition.StayIn -> WorldEditorTexts::goalStayIn
    is GoalCondition.NeverTouch -> WorldEditorTexts::goalNeverTouch
    is GoalCondition.DrawTemplate -> WorldEditorTexts::goalDrawTemplate
    is GoalCondition.InkLength -> WorldEditorTexts::goalInkLength
    is GoalCondition.FollowLine -> WorldEditorTexts::goalFollowLine
    is GoalCondition.EndWithin -> WorldEditorTexts::goalEndWithin
    is GoalCondition.ShowOnDisplay -> WorldEditorTexts::goalShow
    is GoalCondition.PlaySound -> WorldEditorTexts::goalSound
    is GoalCondition.InOrder -> WorldEditorTexts::goalInOrder
    is GoalCondition.All -> WorldEditorTexts::goalAll
    is GoalCondition.AnyOf -> WorldEditorTexts::goalAnyOf
}

/**
 * The labels of a goal's property in a form.
 *
 * @property tag its test tag.
 * @property switchLabel the label of the switch that enables the property; [switchTag] is its test tag.
 */
internal class GoalFieldWords(
    name: String,
    val label: Label,
    val switchLabel: Label = label,
    switchName: String = "has-$name",
) {
    val tag: String = "field-$name"
    val switchTag: String = "field-$switchName"
}

internal fun wordsFor(field: GoalFieldName): GoalFieldWords = when (field) {
    GoalFieldName.WHOLE -> GoalFieldWords("whole", WorldEditorTexts::whole)
    GoalFieldName.STAYS -> GoalFieldWords("stays", WorldEditorTexts::stays)

    GoalFieldName.WITHIN -> GoalFieldWords(
        "seconds",
        WorldEditorTexts::seconds,
        WorldEditorTexts::within,
        "within",
    )

    GoalFieldName.TOUCH_KINDS -> GoalFieldWords("touch", WorldEditorTexts::touchWhat)
    GoalFieldName.TOLERANCE -> GoalFieldWords("tolerance", WorldEditorTexts::tolerance)
    GoalFieldName.COVERAGE -> GoalFieldWords("coverage", WorldEditorTexts::coverage)
    GoalFieldName.EXCESS -> GoalFieldWords("excess", WorldEditorTexts::excess)
    GoalFieldName.MIN_LENGTH -> GoalFieldWords("least", WorldEditorTexts::length, WorldEditorTexts::atLeast)
    GoalFieldName.MAX_LENGTH -> GoalFieldWords("most", WorldEditorTexts::length, WorldEditorTexts::atMost)
    GoalFieldName.LINE -> GoalFieldWords("line", WorldEditorTexts::line)
    GoalFieldName.LAPS -> GoalFieldWords("laps", WorldEditorTexts::laps)
    GoalFieldName.SECONDS -> GoalFieldWords("seconds", WorldEditorTexts::seconds)
    GoalFieldName.TEXT -> GoalFieldWords("text", WorldEditorTexts::text)
    GoalFieldName.TIMES -> GoalFieldWords("times", WorldEditorTexts::times, WorldEditorTexts::counted)
    GoalFieldName.LOWEST_TONE -> GoalFieldWords("lowest", WorldEditorTexts::pitch, WorldEditorTexts::lowest)
    GoalFieldName.HIGHEST_TONE -> GoalFieldWords("highest", WorldEditorTexts::pitch, WorldEditorTexts::highest)
}
