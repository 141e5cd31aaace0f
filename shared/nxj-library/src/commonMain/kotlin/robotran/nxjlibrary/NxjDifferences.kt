package robotran.nxjlibrary

/**
 * All members of the class library that leJOS NXJ 0.9.1 lacks. A program that uses none of them compiles with leJOS NXJ,
 * too. In the sources, the public ones have the tag `@hidden` in their comments, so nothing offers them.
 */
object NxjDifferences {
    private val members = mapOf(
        "java/io/DataOutput" to "write([B)V",
        "java/io/File" to "isDirectory()Z",
        "java/io/IOException" to "<init>(Ljava/lang/String;Ljava/lang/Throwable;)V <init>(Ljava/lang/Throwable;)V",
        "java/lang/ArrayStoreException" to "<init>(Ljava/lang/String;)V",
        "java/lang/Byte" to "compareTo(Ljava/lang/Byte;)I",
        "java/lang/Error" to "<init>(Ljava/lang/String;Ljava/lang/Throwable;)V <init>(Ljava/lang/Throwable;)V",
        "java/lang/Integer" to "signum(I)I",
        "java/lang/Long" to "signum(J)I",
        "java/lang/Math" to "nextUp(D)D nextUp(F)F",
        "java/lang/Runtime" to "gc()V",
        "java/lang/Short" to "compareTo(Ljava/lang/Short;)I",
        "java/lang/String" to "endsWith(Ljava/lang/String;)Z lastIndexOf(I)I lastIndexOf(II)I",
        "java/util/BitSet" to
            "and(Ljava/util/BitSet;)V andNot(Ljava/util/BitSet;)V intersects(Ljava/util/BitSet;)Z " +
            "nextClearBit(I)I nextSetBit(I)I or(Ljava/util/BitSet;)V xor(Ljava/util/BitSet;)V",
        "java/util/Date" to "<init>(J)V getTime()J setTime(J)V",
        "java/util/EmptyQueueException" to "<init>(Ljava/lang/String;)V",
        "java/util/EmptyStackException" to "<init>(Ljava/lang/String;)V",
        "java/util/HashMap" to "<init>(IF)V",
        "java/util/HashSet" to "<init>(I)V <init>(IF)V",
        "java/util/Hashtable" to
            "<init>(I)V clear()V contains(Ljava/lang/Object;)Z containsKey(Ljava/lang/Object;)Z " +
            "elements()Ljava/util/Enumeration; isEmpty()Z remove(Ljava/lang/Object;)Ljava/lang/Object; " +
            "size()I",
        "java/util/LinkedList" to
            "addFirst(Ljava/lang/Object;)V addLast(Ljava/lang/Object;)V element()Ljava/lang/Object; " +
            "getFirst()Ljava/lang/Object; getLast()Ljava/lang/Object; offer(Ljava/lang/Object;)Z " +
            "peek()Ljava/lang/Object; poll()Ljava/lang/Object; remove()Ljava/lang/Object; " +
            "removeFirst()Ljava/lang/Object; removeLast()Ljava/lang/Object;",
        "java/util/Queue" to
            "element()Ljava/lang/Object; offer(Ljava/lang/Object;)Z poll()Ljava/lang/Object; " +
            "remove()Ljava/lang/Object;",
        "java/util/Random" to "nextBytes([B)V setSeed(J)V",
        "java/util/StringTokenizer" to
            "<init>(Ljava/lang/String;Ljava/lang/String;Z)V nextToken(Ljava/lang/String;)Ljava/lang/String;",
        "java/util/Vector" to
            "<init>(Ljava/util/Collection;)V add(ILjava/lang/Object;)V add(Ljava/lang/Object;)Z " +
            "contains(Ljava/lang/Object;)Z copyInto([Ljava/lang/Object;)V firstElement()Ljava/lang/Object; " +
            "get(I)Ljava/lang/Object; lastElement()Ljava/lang/Object; remove(I)Ljava/lang/Object; " +
            "remove(Ljava/lang/Object;)Z set(ILjava/lang/Object;)Ljava/lang/Object;",
        "lejos/nxt/ADSensorPort" to "readRawValues([I)I readValues([I)I",
        "lejos/nxt/Button" to "waitForAnyEvent()I",
        "lejos/nxt/NXT" to "exit(I)V",
        "lejos/nxt/NXTEvent" to "SYSTEM_SHUTDOWN:I",
        "lejos/nxt/comm/Bluetooth" to "connect(Ljavax/bluetooth/RemoteDevice;I)Llejos/nxt/comm/BTConnection;",
        "lejos/nxt/comm/RConsole" to
            "openOutputStream()Ljava/io/OutputStream; openPrintStream()Ljava/io/PrintStream; println()V",
        "lejos/robotics/MirrorMotor" to "getAcceleration()I",
        "lejos/robotics/RegulatedMotor" to "getAcceleration()I",
        "lejos/robotics/RotatingRangeScanner" to
            "<init>(Llejos/robotics/RegulatedMotor;Llejos/robotics/RangeFinder;F)V",
        "lejos/robotics/navigation/Move" to
            "angleTurned:F arcRadius:F distanceTraveled:F isMoving:Z " +
            "moveType:Llejos/robotics/navigation/Move\$MoveType; rotateSpeed:F timeStamp:J travelSpeed:F " +
            "setDynamics(FF)V",
        "lejos/util/PIDController" to "<init>(I)V",
    )

    /** All of them, each once. */
    val all: List<NxjDifference> = members.flatMap { (owner, all) -> all.split(' ').map { NxjDifference(owner, it) } }
}
