package robotran.android

import org.junit.rules.ExternalResource
import org.robolectric.RuntimeEnvironment

/** Each test begins as on a machine on which nobody has worked: Robolectric keeps an app's files from one test to the next. */
class NothingKept : ExternalResource() {
    override fun before() {
        val files = RuntimeEnvironment.getApplication().filesDir
        println("KEPT $files ${files.walk().toList()}")
        files.deleteRecursively()
    }
}
