package robotran.build

import org.gradle.api.file.Directory
import org.gradle.api.file.FileCollection
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.OutputDirectory
import org.gradle.process.CommandLineArgumentProvider

/**
 * Lets Robolectric take its Android framework from a jar that Gradle has fetched, so that it downloads nothing itself.
 */
class RobolectricArguments(
    @get:Classpath val framework: FileCollection,
    /** Where tests put the pictures they take, for people to look at. */
    @get:OutputDirectory val pictures: Provider<Directory>,
) : CommandLineArgumentProvider {
    override fun asArguments(): Iterable<String> = listOf(
        "-Drobolectric.offline=true",
        "-Drobolectric.dependency.dir=${framework.singleFile.parent}",
        "-Drobotran.pictures=${pictures.get().asFile}",
    )
}
