package robotran.ui.drawer

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.ui.empty.EmptyPicture
import robotran.ui.empty.EmptyState
import robotran.ui.run.tags.RunTags
import robotran.uikit.*

/** Explains how to get content for this tab. */
@Composable
internal fun EmptyDrawer(label: Label, picture: EmptyPicture, modifier: Modifier = Modifier) =
    EmptyState(picture, label(spoken), RunTags.DRAWER_EMPTY, modifier)
