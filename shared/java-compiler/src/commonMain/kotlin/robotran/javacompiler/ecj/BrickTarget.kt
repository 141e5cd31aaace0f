package robotran.javacompiler.ecj

/** The system on a brick that programs are compiled for. The order is that of `BrickTarget.java`. */
enum class BrickTarget {
    /** leJOS on an RCX: Java 1.3 without what its virtual machine lacks; class files of version 45.3. */
    LEJOS_RCX,

    /** leJOS NXJ on an NXT: Java 5, and `@Override` as in Java 6; class files of version 50. */
    LEJOS_NXJ,
}
