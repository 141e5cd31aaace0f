package robotran.uikit

import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.ui.graphics.Shape
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp

/** What a button is for. */
enum class ButtonKind(
    internal val form: ButtonForm,
    internal val tone: ButtonTone,
    internal val style: TextStyle = TextStyles.body.medium,
) {
    /** The recommended action of a page or card. */
    PRIMARY(ButtonForm.CARD, ButtonTone.YELLOW),

    /** Another action there. */
    SECOND(ButtonForm.CARD, ButtonTone.FRAME),

    /** A rare action there. */
    QUIET(ButtonForm.CARD, ButtonTone.PLAIN),

    /** The recommended action of a dialog. */
    DIALOG_MAIN(ButtonForm.DIALOG, ButtonTone.YELLOW),

    /** One of several answers within a dialog. */
    DIALOG_ANSWER(ButtonForm.DIALOG, ButtonTone.FINE_FRAME),

    /** Another action of a dialog. */
    DIALOG_OTHER(ButtonForm.DIALOG_PLAIN, ButtonTone.PLAIN),

    /** The recommended action of the bar of an editor. */
    EDITOR_BAR(ButtonForm.EDITOR_BAR, ButtonTone.YELLOW),

    /** An action among the fields of an editor. */
    EDITOR(ButtonForm.EDITOR, ButtonTone.FRAME, TextStyles.compact.medium),

    /** The recommended action of the run bar. */
    RUN(ButtonForm.RUN_BAR, ButtonTone.YELLOW),

    /** Another action of the run bar. */
    RUN_OTHER(ButtonForm.RUN_BAR, ButtonTone.STRONG_FRAME),

    /** An action beside a sentence. */
    LINK(ButtonForm.DIALOG_PLAIN, ButtonTone.LINK, TextStyles.body.strong),

    /** The same in a narrow place. */
    SMALL_LINK(ButtonForm.DIALOG_PLAIN, ButtonTone.LINK, TextStyles.compact),

    /** An action in a row of controls. */
    TOOL(ButtonForm.TOOL, ButtonTone.PLAIN, TextStyles.compact),
}

/** The shape of a button, and the [padding] of its content. */
internal enum class ButtonForm(val shape: Shape, val padding: PaddingValues, val ring: Dp, val minHeight: Dp) {
    CARD(Shapes.MEDIUM, PaddingValues(16.dp, 8.dp), Corners.MEDIUM, Dimensions.TARGET),
    DIALOG(CircleShape, PaddingValues(24.dp, 8.dp), Dimensions.TARGET / 2, Dimensions.TARGET),
    DIALOG_PLAIN(CircleShape, PaddingValues(12.dp, 8.dp), Dimensions.TARGET / 2, Dimensions.TARGET),
    EDITOR_BAR(Shapes.MEDIUM, PaddingValues(24.dp, 8.dp), Corners.MEDIUM, Dimensions.TARGET),
    EDITOR(Shapes.MEDIUM, PaddingValues(14.dp, 8.dp), Corners.MEDIUM, Dimensions.TARGET),
    TOOL(Shapes.MEDIUM, PaddingValues(12.dp, 8.dp), Corners.MEDIUM, Dimensions.TARGET),
    RUN_BAR(Shapes.LARGE, PaddingValues(horizontal = 16.dp), Corners.LARGE, 56.dp),
}

/** How a button stands out. */
internal enum class ButtonTone { YELLOW, FRAME, FINE_FRAME, STRONG_FRAME, PLAIN, LINK }
