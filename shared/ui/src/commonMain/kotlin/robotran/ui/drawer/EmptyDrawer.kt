package robotran.ui.drawer

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyState

/** Explains how to get content for this tab. */
@Composable
internal fun EmptyDrawer(words: StringResource, picture: EmptyPicture, modifier: Modifier = Modifier) =
    EmptyState(picture, stringResource(words), "drawer-empty", modifier)
