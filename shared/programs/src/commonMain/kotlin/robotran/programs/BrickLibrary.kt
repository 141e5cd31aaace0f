package robotran.programs

import robotran.lejoslibrary.LejosDifference
import robotran.lejoslibrary.LejosDifferences
import robotran.lejoslibrary.LejosLibrary
import robotran.lejoslibrary.LejosRemedy
import robotran.tinyvm.config.TinyVmMode

/** The class files of leJOS. Each property is always the same map, so that the compiler reads the classes only once. */
internal object BrickLibrary {
    private const val UNCHECKED_EXCEPTION = "java/lang/RuntimeException"
    private const val CHECKED_EXCEPTION = "java/lang/Exception"

    /** For [TinyVmMode.FORGIVING]: as Java says. */
    val classFiles: Map<String, ByteArray> by lazy {
        LejosLibrary.classNames.associateWith { checkNotNull(LejosLibrary.classFile(it)) }
    }

    /** For [TinyVmMode.BRICK]: exceptions that are checked on a brick extend `Exception`, not `RuntimeException`. */
    val classFilesOfBrick: Map<String, ByteArray> by lazy {
        val checked = LejosDifferences.all.filter { it.instead == LejosRemedy.CHECKED_EXCEPTION }.map { it.owner }
        classFiles + checked.associateWith {
            withClassReplaced(classFiles.getValue(it), UNCHECKED_EXCEPTION, CHECKED_EXCEPTION)
        }
    }

    /** The class files that a program with [settings] is compiled against and linked with. */
    fun classFilesFor(settings: JavaSettings): Map<String, ByteArray> = when (settings.mode) {
        TinyVmMode.BRICK -> classFilesOfBrick
        TinyVmMode.FORGIVING -> classFiles
    }

    /** What a program with [settings] must not use, because the brick that it is for does not have it. */
    fun missingFor(settings: JavaSettings): List<LejosDifference> = when (settings.mode) {
        TinyVmMode.BRICK -> LejosDifferences.all.filterNot { it.isIn(settings.version) }
        TinyVmMode.FORGIVING -> emptyList()
    }
}
