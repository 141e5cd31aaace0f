package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.NxjRemedy

/** Classes, and members with their class, that other programs use and an NXT with leJOS NXJ does not have. */
private val ABSENT: Map<String, NxjRemedy> = buildMap {
    fun put(remedy: NxjRemedy, names: String) = names.split(' ').forEach { put(it, remedy) }
    put(NxjRemedy.PRINT, "Assertion")
    put(NxjRemedy.BUTTONS, "System.in System.console Scanner Console")
    put(NxjRemedy.SORT_ARRAY, "Collections Comparator ArrayList.sort LinkedList.sort Vector.sort List.sort")
    put(NxjRemedy.HASH_MAP, "TreeMap LinkedHashMap SortedMap NavigableMap")
    put(NxjRemedy.HASH_MAP, "EnumMap ConcurrentHashMap WeakHashMap Dictionary")
    put(NxjRemedy.HASH_SET, "TreeSet LinkedHashSet SortedSet NavigableSet EnumSet")
    put(NxjRemedy.LINKED_LIST, "Deque ArrayDeque PriorityQueue BlockingQueue ConcurrentLinkedQueue LinkedBlockingQueue")
    put(NxjRemedy.FILL_LIST, "List.of Set.of Map.of Arrays.asList")
    for (collection in listOf("ArrayList", "LinkedList", "List", "Set", "HashSet", "Collection")) {
        put(NxjRemedy.LOOP, "$collection.forEach $collection.stream $collection.removeIf $collection.replaceAll")
    }
    put(NxjRemedy.LOOP, "Stream IntStream Collectors HashMap.forEach Map.forEach HashMap.getOrDefault Map.getOrDefault")
    put(NxjRemedy.LOOP, "HashMap.computeIfAbsent HashMap.merge HashMap.putIfAbsent Map.putIfAbsent Map.merge")
    put(NxjRemedy.OWN_CLASS, "Function BiFunction Supplier Consumer BiConsumer Predicate UnaryOperator IntFunction")
    put(NxjRemedy.OWN_CLASS, "Objects Observer Observable EventListener PropertyChangeListener")
    put(NxjRemedy.NULL, "Optional OptionalInt OptionalDouble")
    put(NxjRemedy.JOIN_TEXTS, "String.format String.join String.repeat")
    put(NxjRemedy.JOIN_TEXTS, "String.formatted PrintStream.printf PrintStream.format")
    put(NxjRemedy.JOIN_TEXTS, "Formatter DecimalFormat NumberFormat MessageFormat SimpleDateFormat Locale StringJoiner")
    put(NxjRemedy.TOKENIZER, "String.split StreamTokenizer")
    put(NxjRemedy.COMPARE_TEXTS, "String.matches String.replaceAll String.replaceFirst Pattern Matcher String.strip")
    put(NxjRemedy.COMPARE_TEXTS, "String.isBlank String.lines")
    put(NxjRemedy.COMPARE_TEXTS, "String.chars String.compareToIgnoreCase String.regionMatches")
    put(NxjRemedy.COMPARE_TEXTS, "String.stripLeading String.stripTrailing")
    put(NxjRemedy.INDEX_OF, "String.contains")
    for (builder in listOf("StringBuilder", "StringBuffer")) {
        put(NxjRemedy.SUBSTRINGS, "$builder.insert $builder.replace")
    }
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.isLetter Character.isLetterOrDigit")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.isUpperCase Character.isLowerCase")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.isWhitespace Character.toUpperCase")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.toLowerCase Character.isAlphabetic")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.getNumericValue Character.isSpaceChar")
    put(NxjRemedy.CALCULATE, "Math.floorMod Math.floorDiv Math.hypot Math.cbrt")
    put(NxjRemedy.CALCULATE, "Math.log10 Math.sinh Math.cosh Math.tanh Math.clamp")
    put(NxjRemedy.CALCULATE, "Math.addExact Math.multiplyExact Math.subtractExact")
    put(NxjRemedy.CALCULATE, "Math.toIntExact Math.ulp Math.expm1 Math.log1p")
    put(NxjRemedy.CALCULATE, "StrictMath Integer.compare Integer.max")
    put(NxjRemedy.CALCULATE, "Integer.min Integer.sum Long.compare Boolean.compare")
    put(NxjRemedy.ARRAY_LOOP, "Arrays.stream Arrays.hashCode Arrays.deepToString Arrays.deepEquals Arrays.setAll")
    put(NxjRemedy.THREADS, "Executor ExecutorService Executors Callable")
    put(NxjRemedy.THREADS, "Future CompletableFuture CountDownLatch Semaphore")
    put(NxjRemedy.THREADS, "Lock ReentrantLock AtomicInteger AtomicBoolean")
    put(NxjRemedy.THREADS, "AtomicLong AtomicReference TimeUnit ThreadLocal")
    put(NxjRemedy.THREADS, "ThreadGroup CyclicBarrier ConcurrentMap")
    put(NxjRemedy.END_THREAD, "Thread.stop Thread.suspend Thread.resume Thread.destroy")
    put(NxjRemedy.STOPWATCH, "Date.getTime Date.setTime")
    put(NxjRemedy.BITS, "BitSet.and BitSet.andNot BitSet.or BitSet.xor BitSet.intersects")
    put(NxjRemedy.NO_FOLDERS, "File.isDirectory File.mkdir File.mkdirs File.getParent File.list")
    put(NxjRemedy.OTHER_PROGRAM, "File.exec")
    put(NxjRemedy.OWN_VARIABLE, "RegulatedMotor.getAcceleration MirrorMotor.getAcceleration")
    put(NxjRemedy.CALCULATE, "Math.nextUp")
    put(NxjRemedy.BITS, "BitSet.nextSetBit BitSet.nextClearBit")
    put(NxjRemedy.STOPWATCH, "Calendar GregorianCalendar LocalDate LocalTime LocalDateTime Instant Duration")
    put(NxjRemedy.LONG_OR_DOUBLE, "BigInteger BigDecimal")
    put(NxjRemedy.RANDOM, "SecureRandom ThreadLocalRandom UUID SplittableRandom")
    put(NxjRemedy.INSTANCEOF, "Class.getName Class.getSimpleName")
    put(NxjRemedy.INSTANCEOF, "Class.newInstance Class.getMethods Class.getDeclaredFields")
    put(NxjRemedy.LCD, "JFrame JPanel JButton JLabel JOptionPane Frame Color.getRGB SwingUtilities")
    put(NxjRemedy.PIXELS, "Canvas GameCanvas TiledLayer LayerManager")
    put(NxjRemedy.PIXELS, "Graphics2D LCD.drawLine LCD.drawRect LCD.fillRect LCD.drawArc LCD.drawImage LCD.fillArc")
    put(NxjRemedy.FILE_STREAMS, "FileReader FileWriter PrintWriter RandomAccessFile Files Path.of Paths")
    put(NxjRemedy.DATA_STREAMS, "ObjectOutputStream ObjectInputStream Externalizable StringReader StringWriter")
    put(NxjRemedy.BLUETOOTH, "Socket ServerSocket URL InetAddress NXTCommand RemoteMotor RemoteNXT LCP InBox")
    put(NxjRemedy.BLUETOOTH, "LCPBTResponder LCPResponder LCPMessageListener NXTCommDevice NXTCommRequest")
    put(NxjRemedy.BLUETOOTH, "RS485.hsEnable RS485.hsDisable RS485.hsRead RS485.hsWrite RS485.hsSend RS485.hsRecv")
    put(NxjRemedy.BLUETOOTH, "USB.usbEnable USB.usbDisable USB.usbRead USB.usbWrite USB.usbReset USB.usbStatus")
    put(NxjRemedy.BLUETOOTH, "USB.usbSetName USB.usbSetSerialNo USB.RESET USB.USB_CONFIGURED USB.USB_READABLE")
    put(NxjRemedy.BLUETOOTH, "USB.USB_UNCONFIGURED USB.USB_WRITEABLE")
    put(NxjRemedy.BLUETOOTH, "BTConnection.openStream BTConnection.closeStream BTConnection.setActiveMode")
    put(NxjRemedy.BLUETOOTH, "BTConnection.AM_ALWAYS BTConnection.AM_DISABLE BTConnection.AM_OUTPUT")
    for (member in CHIP_OF_BLUETOOTH.split(' ')) put("Bluetooth.$member", NxjRemedy.BLUETOOTH_BY_NAME)
    put(NxjRemedy.BLUETOOTH_BY_NAME, "BTConnection.getSignalStrength")
    put(NxjRemedy.LINE_FEED, "System.lineSeparator System.getenv")
    put(NxjRemedy.NXT_MOTOR, "NXTRegulatedMotor.setPower NXTRegulatedMotor.getPower RegulatedMotor.setPower")
    put(NxjRemedy.ALWAYS_REGULATED, "NXTRegulatedMotor.regulateSpeed NXTRegulatedMotor.smoothAcceleration")
    put(NxjRemedy.ALWAYS_REGULATED, "NXTRegulatedMotor.isRegulating NXTRegulatedMotor.setBrakePower")
    for (motor in listOf("NXTRegulatedMotor", "RegulatedMotor", "NXTMotor")) {
        put(NxjRemedy.MOTOR_DIRECTIONS, "$motor.run $motor.start $motor.on $motor.turnOn $motor.go $motor.drive")
        put(NxjRemedy.MOTOR_DIRECTIONS, "$motor.move $motor.off $motor.turnOff $motor.brake")
    }
    put(NxjRemedy.MOTOR_ROTATE, "NXTRegulatedMotor.turn RegulatedMotor.turn NXTRegulatedMotor.rotateFor")
    put(NxjRemedy.ROTATION_SPEED, "NXTRegulatedMotor.getActualSpeed RegulatedMotor.getActualSpeed")
    put(NxjRemedy.IS_MOVING, "NXTRegulatedMotor.isRotating RegulatedMotor.isRotating NXTRegulatedMotor.isForward")
    put(NxjRemedy.IS_MOVING, "NXTRegulatedMotor.isBackward NXTRegulatedMotor.isStopped NXTRegulatedMotor.isFloating")
    put(NxjRemedy.DIFFERENTIAL_PILOT, "Pilot TachoPilot LegacyPilot CompassPilot MovePilot WheeledChassis")
    put(NxjRemedy.DIFFERENTIAL_PILOT, "Chassis OmniPilot TwoWheelPilot PseudoSteeringPilot RobotArm RobotHand")
    put(NxjRemedy.DIFFERENTIAL_PILOT, "ArcAlgorithms")
    put(NxjRemedy.BALANCE, "SegowayPilot Segoway Segway SegwayPilot Ballbot")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setMoveSpeed")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setSpeed DifferentialPilot.setTurnSpeed")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setLinearSpeed")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setAngularSpeed DifferentialPilot.getMoveSpeed")
    put(NxjRemedy.NAVIGATOR, "SimpleNavigator TachoNavigator LegacyNavigator CompassNavigator NavPathController")
    put(NxjRemedy.LINE_MAP, "SVGMapLoader OccupancyGridMap GridMap DijkstraPathFinder")
    put(NxjRemedy.ODOMETRY, "GPSPoseProvider DeadReckonerPoseProvider TachoPoseProvider CompassPoseProvider")
    put(NxjRemedy.NO_COMPUTER, "NavigationModel NXTNavigationModel NavEventListener LogMessageManager PIDTuner")
    put(NxjRemedy.NO_COMPUTER, "PIDTuningProvider LogMessageListener LogMessageTypeHandler LoggerDebugConsole")
    put(NxjRemedy.NO_COMPUTER, "SimpleDrive SimpleDriveProvider")
    put(NxjRemedy.DATA_STREAMS, "EndianTools RingBuffer BitUtils")
    put(NxjRemedy.SENSORS, "NXTCam NXTLineLeader RFIDSensor PressureSensor BarometricSensor BarometricHTSensor")
    put(NxjRemedy.SENSORS, "MindSensorPressureSensor MindSensorsPressureSensor DPressure250 DPressure500 DThermalIR")
    put(NxjRemedy.SENSORS, "DGPSSensor DexterGPSSensor RealTimeClock TouchPanel MindSensorsNumPad PSPNXController")
    put(NxjRemedy.SENSORS, "HiTechnicPIRSensor LaserSensor DexterLaserSensor LaserBeaconLocator MagneticSensor")
    put(NxjRemedy.SENSORS, "DLight DLights")
    put(NxjRemedy.SENSORS, "PowerMeter NXTPowerMeter NXTBee NXT2WIFI NXT2WiFiListener DexterWifiSensor WifiSensor")
    put(NxjRemedy.COMPASS, "CompassSensor DexterCompassSensor DIMUCompass AbsoluteImuAgcMindSensor")
    put(NxjRemedy.GYRO, "CruizcoreGyro DIMUGyro")
    put(NxjRemedy.ACCELERATION, "TiltSensor DIMUAccel AccelSensor")
    put(NxjRemedy.DISTANCE, "EOPD NXTSumoEyes SumoEyesSensor")
    put(NxjRemedy.COUNT_TURNS, "AngleSensor")
    put(NxjRemedy.THERMOMETER, "RCXTemperatureSensor")
    put(NxjRemedy.RCX_LINK, "IRLink RCXPort LLC LLCHandler LLCReliableHandler RCXAbstractPort")
    put(NxjRemedy.ONE_PORT_EACH, "TouchMUX SensorMux SensorSelector SensorSelectorException RCXSensorMultiplexer")
    put(NxjRemedy.THREE_MOTORS, "PFLink PFMate PFMateMotor PFMotorPort RCXMotorMultiplexer RCXPlexedMotorPort NXTMMX")
    put(NxjRemedy.THREE_MOTORS, "MMXMotor MMXRegulatedMotor NXTe LDCMotor LMotor LServo LSC MServo MSC")
    put(NxjRemedy.THREE_MOTORS, "LnrActrFirgelliNXT")
    put(NxjRemedy.THREE_MOTORS, "TetrixControllerFactory TetrixEncoderMotor TetrixMotor TetrixMotorController")
    put(NxjRemedy.THREE_MOTORS, "TetrixRegulatedMotor TetrixServo TetrixServoController")
    put(NxjRemedy.NOT_EV3, "LocalEV3 BrickFinder EV3 SampleProvider GraphicsLCD TextLCD EV3TouchSensor EV3ColorSensor")
    put(NxjRemedy.NOT_EV3, "EV3UltrasonicSensor EV3GyroSensor EV3IRSensor NXTTouchSensor NXTUltrasonicSensor Keys LED")
    put(NxjRemedy.MOTOR_OF_PORT, "EV3LargeRegulatedMotor EV3MediumRegulatedMotor UnregulatedMotor")
    put(NxjRemedy.DRAW, "LCD.showNumber LCD.setNumber LCD.showProgramNumber LCD.setSegment LCD.print LCD.println")
    put(NxjRemedy.SENSOR_PORT, "Sensor SensorConstants.SENSOR_TYPE_LIGHT Sensor.S1 Sensor.S2 Sensor.S3 ProximitySensor")
    put(NxjRemedy.NXT_BUTTONS, "Button.RUN Button.VIEW Button.PRGM Button.UP Button.DOWN")
    put(NxjRemedy.BLUETOOTH, "Serial PacketHandler DiscoveryAgent DiscoveryListener")
    put(NxjRemedy.MENU_SETTINGS, "Button.loadSettings Button.loadSystemSettings Sound.loadSettings SystemSettings")
    put(NxjRemedy.NXT_LISTENERS, "NXTEvent.notifyEvent")
    put(NxjRemedy.NXT_LISTENERS, "NXTEvent.clearEvent NXTEvent.getEventData NXTEvent.setFilter NXTEvent.getFilter")
    put(NxjRemedy.NXT_LISTENERS, "NXTEvent.NONE NXTEvent.TIMEOUT")
    put(NxjRemedy.NXT_LISTENERS, "NXTEvent.BLUETOOTH NXTEvent.USB NXTEvent.RS485 NXTEvent.I2C_PORTS")
    put(NxjRemedy.NXT_LISTENERS, "NXTEvent.USER1 NXTEvent.USER2 NXTEvent.USER3 NXTEvent.USER4")
    put(NxjRemedy.BREAKPOINTS, "VM.getVM VM.getImage VM.getVMThreads VM.getVMThread VM.getElements VM.getFields")
    put(NxjRemedy.BREAKPOINTS, "VM.getClass VM.getVMClass VM.getMethod VM.getClassNumber VM.getThrowableStackTrace")
    put(NxjRemedy.BREAKPOINTS, "VM.suspendThread VM.resumeThread VM.executeProgram VM.setVMOptions VM.getVMOptions")
    put(NxjRemedy.BREAKPOINTS, "VM.isArray VM.isAssignable VM.enableRunTimeTypeChecks NXT.boot NXT.getUserPages")
    put(NxjRemedy.BREAKPOINTS, "NXT.getProgramExecutionsCount VM.VM_TYPECHECKS VM.VM_ASSERT")
}

/** What leJOS NXJ's class `Bluetooth` has beside connections by name: its chip and its list of devices. */
private const val CHIP_OF_BLUETOOTH =
    "addDevice removeDevice getKnownDevicesList inquire inquireNotify cancelInquiry lookupName getConnectionStatus " +
        "getOperatingMode setOperatingMode getPin setPin getPower setPower getPortOpen openPort closePort " +
        "closeConnection getResetCount getSignalStrength getStatus setStatus getVersion getVisibility setVisibility " +
        "loadSettings reset setFactorySettings setFriendlyName PIN btDisable btEnable btGetBC4CmdMode btPending " +
        "btRead btReceive btSend btSetArmCmdMode btSetCmdMode btSetResetHigh btSetResetLow btWrite"

/** Methods that other programs call without a class or an object. */
private val ABSENT_CALLS = mapOf(
    "print" to NxjRemedy.PRINT,
    "println" to NxjRemedy.PRINT,
    "printf" to NxjRemedy.PRINT,
    "readLine" to NxjRemedy.BUTTONS,
    "input" to NxjRemedy.BUTTONS,
    "sleep" to NxjRemedy.WAIT,
    "delay" to NxjRemedy.WAIT,
    "pause" to NxjRemedy.WAIT,
    "msDelay" to NxjRemedy.WAIT,
    "waitForAnyPress" to NxjRemedy.BUTTONS,
)

/** The beginnings of imports that an NXT with leJOS NXJ does not have. */
private val ABSENT_PACKAGES = listOf(
    "josx" to NxjRemedy.NOT_RCX,
    "lejos.hardware" to NxjRemedy.NOT_EV3,
    "lejos.remote" to NxjRemedy.NOT_EV3,
    "lejos.robotics.chassis" to NxjRemedy.DIFFERENTIAL_PILOT,
    "lejos.robotics.mapping" to NxjRemedy.LINE_MAP,
    "lejos.robotics.localization" to NxjRemedy.ODOMETRY,
    "lejos.robotics.filter" to NxjRemedy.SENSORS,
    "lejos.robotics.kinematics" to NxjRemedy.DIFFERENTIAL_PILOT,
    "lejos.nxt.Settings" to NxjRemedy.MENU_SETTINGS,
    "lejos.nxt.addon" to NxjRemedy.SENSORS,
    "lejos.nxt.remote" to NxjRemedy.BLUETOOTH,
    "lejos.pc" to NxjRemedy.BLUETOOTH,
    "javax.bluetooth" to NxjRemedy.BLUETOOTH,
    "javax.microedition.sensor" to NxjRemedy.SENSORS,
    "javax.microedition.location" to NxjRemedy.ODOMETRY,
    "javax.microedition.io" to NxjRemedy.BLUETOOTH,
    "javax.microedition.lcdui.game" to NxjRemedy.PIXELS,
    "javax.xml" to NxjRemedy.LINE_MAP,
    "javax.net" to NxjRemedy.BLUETOOTH,
    "javax.swing" to NxjRemedy.LCD,
    "java.awt" to NxjRemedy.LCD,
    "java.net" to NxjRemedy.BLUETOOTH,
    "java.nio" to NxjRemedy.FILE_STREAMS,
    "java.text" to NxjRemedy.JOIN_TEXTS,
    "java.time" to NxjRemedy.STOPWATCH,
    "java.math" to NxjRemedy.LONG_OR_DOUBLE,
    "java.lang.reflect" to NxjRemedy.INSTANCEOF,
    "java.util.function" to NxjRemedy.OWN_CLASS,
    "java.util.concurrent" to NxjRemedy.THREADS,
    "java.util.stream" to NxjRemedy.LOOP,
    "java.util.regex" to NxjRemedy.COMPARE_TEXTS,
)

/** What a program does without [name], a class, an import or a member of [owner]; null if nothing is known. */
internal fun nxjRemedy(name: String, owner: String? = null): NxjRemedy? {
    if (owner != null) return ABSENT["$owner.$name"]
    val ofClass = ABSENT[name.substringAfterLast('.')]
    return ofClass ?: ABSENT_PACKAGES.firstOrNull { (start, _) -> name == start || name.startsWith("$start.") }?.second
}

/** What a program does without [method], which it calls without a class or an object; null if nothing is known. */
internal fun nxjRemedyOfCall(method: String): NxjRemedy? = ABSENT_CALLS[method]

/** The names in this table: classes, and members with their class. */
internal val namesAbsentFromNxj: Set<String> get() = ABSENT.keys
