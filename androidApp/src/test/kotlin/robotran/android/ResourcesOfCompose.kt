package robotran.android

import android.content.ContentProvider
import org.junit.rules.ExternalResource
import org.robolectric.RuntimeEnvironment

/**
 * Starts the [ContentProvider] by which Compose finds its resources. Android starts an app's providers before its first
 * activity, Robolectric only when somebody asks for them.
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
