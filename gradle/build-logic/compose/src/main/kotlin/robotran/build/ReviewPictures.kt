package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test

/**
 * `reviewPictures`: the classes whose names end with `Pictures`. They draw hundreds of pictures for people to look at
 * and compare none of them, so `check` leaves them out. Golden pictures are in classes named `..PicturesTest`.
 */
object ReviewPictures {
    private const val TASK = "reviewPictures"
    private const val CLASSES = "*Pictures"
    private const val FILES = "src/jvmTest/**/*Pictures.kt"

    fun register(project: Project) {
        if (project.fileTree(project.projectDir) { it.include(FILES) }.isEmpty) return
        val jvmTest = project.tasks.named("jvmTest", Test::class.java)
        jvmTest.configure { it.filter.excludeTestsMatching(CLASSES) }
        TestParts.register(project, "jvmTest", TASK, listOf(CLASSES)).configure { task ->
            task.group = "documentation"
            task.description = "Draws pictures of the screens for review into build/review-pictures."
        }
    }

    /** The folder below `build` for the pictures of [test]: each task has its own, so that Gradle keeps their results. */
    fun folder(test: Test): String = when (test.name) {
        TASK -> "review-pictures"
        "jvmTest" -> "pictures"
        else -> "${test.name}-pictures"
    }
}
