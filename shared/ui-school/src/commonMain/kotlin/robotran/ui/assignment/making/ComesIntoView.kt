package robotran.ui.assignment.making

import androidx.compose.foundation.ExperimentalFoundationApi
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.relocation.BringIntoViewRequester
import androidx.compose.foundation.relocation.bringIntoViewRequester
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp

/** [content], the result of what was pressed above it. Each other [news] scrolls it into view; null does not. */
@OptIn(ExperimentalFoundationApi::class)
@Composable
internal fun ComesIntoView(news: Any?, content: @Composable ColumnScope.() -> Unit) {
    val requester = remember { BringIntoViewRequester() }
    LaunchedEffect(news) {
        if (news == null) return@LaunchedEffect
        // Only the next frame knows how large it is.
        withFrameNanos { }
        requester.bringIntoView()
    }
    Column(
        Modifier.fillMaxWidth().bringIntoViewRequester(requester),
        Arrangement.spacedBy(8.dp),
        content = content,
    )
}
