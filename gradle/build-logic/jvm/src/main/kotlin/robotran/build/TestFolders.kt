package robotran.build

import org.gradle.api.Project
import org.gradle.api.file.Directory
import org.gradle.api.provider.Provider
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.testing.Test
import org.gradle.process.CommandLineArgumentProvider
import java.io.File

/**
 * Folders that tests find in system properties. Their absolute paths are no inputs of the tests, so that all clones of
 * the tree share the results.
 */
object TestFolders {
    /** What tests read in the tree: programs and worlds, and the recorded runs to compare theirs with. */
    private val READ = listOf(
        "examples",
        "worlds",
        "shared/robolang/src/commonTest/resources/programs",
        "shared/simulation/src/commonTest/resources/runs",
        "shared/programs/src/commonTest/resources/runs",
        "shared/projects/src/commonTest/resources",
    )

    /** `robotran.tree`: the root of the tree. The tests run again after a change of [READ]. */
    fun giveTree(project: Project, test: Test) {
        test.jvmArgumentProviders.add(TestTree(project.rootDir))
        for (folder in READ) {
            test.inputs.dir(project.rootProject.file(folder)).withPathSensitivity(PathSensitivity.RELATIVE)
        }
    }

    /** `robotran.pictures`: [folder] below `build`, for screenshots, for manual review. */
    fun givePictures(project: Project, test: Test, folder: String = "pictures") {
        test.jvmArgumentProviders.add(TestPictures(project.layout.buildDirectory.dir(folder)))
    }
}

private class TestTree(
    @get:Internal val root: File,
) : CommandLineArgumentProvider {
    override fun asArguments(): Iterable<String> = listOf("-Drobotran.tree=$root")
}

private class TestPictures(
    @get:OutputDirectory val folder: Provider<Directory>,
) : CommandLineArgumentProvider {
    override fun asArguments(): Iterable<String> = listOf("-Drobotran.pictures=${folder.get().asFile}")
}
