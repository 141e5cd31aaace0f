package robotran.android

import android.content.ContentProvider
import org.junit.rules.ExternalResource
import org.robolectric.RuntimeEnvironment

/**
 * Starts the [ContentProvider] that locates Compose's resources. Android starts providers before the first activity,
 * Robolectric only on request.
 */
class ResourcesOfCompose : ExternalResource() {
    override fun before() {
        val app = RuntimeEnvironment.getApplication()
        val authority = "${app.packageName}.resources.AndroidContextProvider"
        checkNotNull(app.contentResolver.acquireContentProviderClient(authority)) {
            "The manifest has no $authority"
        }.close()
    }
}
