package robotran.build

import org.gradle.api.file.FileCollection
import org.gradle.api.tasks.Classpath
import org.gradle.process.CommandLineArgumentProvider

/** Makes Robolectric use an Android framework jar resolved by Gradle, so that it downloads nothing. */
class RobolectricArguments(
    @get:Classpath val framework: FileCollection,
) : CommandLineArgumentProvider {
    override fun asArguments(): Iterable<String> = listOf(
        "-Drobolectric.offline=true",
        "-Drobolectric.dependency.dir=${framework.singleFile.parent}",
    )
}
