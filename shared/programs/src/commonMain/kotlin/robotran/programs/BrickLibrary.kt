package robotran.programs

import robotran.lejoslibrary.LejosLibrary

/** The class files of leJOS. It is always the same map, so that the compiler reads the classes only once. */
internal object BrickLibrary {
    val classFiles: Map<String, ByteArray> by lazy {
        LejosLibrary.classNames.associateWith { checkNotNull(LejosLibrary.classFile(it)) }
    }
}
