package robotran.programs

import robotran.javacompiler.ecj.BrickTarget
import robotran.lejoslibrary.LejosDifference
import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.config.TinyVmMode

/**
 * What Java programs are compiled against.
 *
 * @property classFiles always the same map for a library, so that the compiler reads the classes only once.
 * @property missing what a program must not use although it is among [classFiles].
 */
internal class JavaLibrary private constructor(
    val target: BrickTarget,
    val classFiles: Map<String, ByteArray>,
    val missing: List<LejosDifference>,
) {
    companion object {
        fun ofLejos(settings: JavaSettings) = JavaLibrary(
            BrickTarget.LEJOS_RCX,
            BrickLibrary.classFilesFor(settings),
            BrickLibrary.missingFor(settings),
        )

        fun ofNxj(library: NxjLibrary, settings: JavaSettings) = JavaLibrary(
            BrickTarget.LEJOS_NXJ,
            when (settings.mode) {
                TinyVmMode.BRICK -> library.classFilesOfBrick
                TinyVmMode.FORGIVING -> library.classFiles
            },
            emptyList(),
        )
    }
}
