package robotran.nxjlibrary

import kotlin.test.Test
import kotlin.test.assertEquals

/** What public programs for leJOS NXJ use most is there. */
class NeededApiTest {
    private val types = libraryClasses.associateBy { it.className }

    @Test
    fun `the members that programs use most are there`() {
        val missing = NEEDED.flatMap { (type, names) ->
            if (type !in types) listOf(type) else names.split(' ').filterNot { has(type, it) }.map { "$type.$it" }
        }
        assertEquals(emptyList(), missing)
    }

    /** Whether the class [type], its superclasses or its interfaces have a member [name] that is not private. */
    private fun has(type: String?, name: String): Boolean {
        val found = types[type] ?: return false
        val methods = found.methods.filterNot { it.isPrivate }.map { it.name.replace("<init>", "new") }
        val fields = found.fields.filterNot { it.isPrivate }.map { it.name }
        val above = found.interfaceNames.toList() + listOfNotNull(found.superclassName.takeIf { it != type })
        return name in methods + fields || above.any { has(it, name) }
    }

    private companion object {
        const val MOTOR =
            "forward backward stop flt rotate rotateTo getTachoCount resetTachoCount setSpeed getSpeed getMaxSpeed " +
                "setAcceleration getAcceleration isMoving waitComplete isStalled setStallThreshold getRotationSpeed " +
                "getLimitAngle addListener removeListener"

        val NEEDED = mapOf(
            "lejos.nxt.Motor" to "A B C getInstance",
            "lejos.nxt.NXTRegulatedMotor" to "new $MOTOR getPosition suspendRegulation lock",
            "lejos.nxt.NXTMotor" to
                "new setPower getPower forward backward stop flt isMoving getTachoCount resetTachoCount",
            "lejos.nxt.MotorPort" to "A B C getInstance controlMotor getTachoCount resetTachoCount getId setPWMMode",
            "lejos.nxt.BasicMotorPort" to "PWM_FLOAT PWM_BRAKE FORWARD BACKWARD STOP FLOAT MAX_POWER",
            "lejos.nxt.SensorPort" to "S1 S2 S3 S4 getInstance PORTS getId readRawValue readValue readBooleanValue " +
                "setTypeAndMode setType setMode getType getMode reset activate passivate setPowerType " +
                "addSensorPortListener setListenerTolerance i2cEnable i2cDisable i2cTransaction setSensorPin " +
                "getSensorPin readSensorPin setSensorPinMode enableColorSensor readValues readRawValues",
            "lejos.nxt.SensorPortListener" to "stateChanged",
            "lejos.nxt.TouchSensor" to "new isPressed",
            "lejos.nxt.LightSensor" to "new getLightValue readValue getNormalizedLightValue readNormalizedValue " +
                "setFloodlight isFloodlightOn getFloodlight calibrateLow calibrateHigh setLow setHigh getLow getHigh",
            "lejos.nxt.SoundSensor" to "new readValue setDBA",
            "lejos.nxt.UltrasonicSensor" to
                "new getDistance getRange getRanges getDistances ping continuous capture off " +
                "reset setMode MODE_OFF MODE_PING MODE_CONTINUOUS MODE_CAPTURE MODE_RESET getMode getActualMode " +
                "getUnits " +
                "getContinuousInterval setContinuousInterval getVersion getVendorID getProductID getData " +
                "sendData getAddress",
            "lejos.nxt.ColorSensor" to "new getColorID getColor getRawColor getLightValue getNormalizedLightValue " +
                "setFloodlight calibrateLow calibrateHigh setLow setHigh",
            "lejos.nxt.LCD" to "drawString drawChar drawInt clear clearDisplay refresh asyncRefresh asyncRefreshWait " +
                "setAutoRefresh setAutoRefreshPeriod setPixel getPixel scroll bitBlt getDisplay setContrast " +
                "SCREEN_WIDTH " +
                "SCREEN_HEIGHT DISPLAY_CHAR_WIDTH DISPLAY_CHAR_DEPTH CELL_WIDTH CELL_HEIGHT FONT_WIDTH " +
                "FONT_HEIGHT NOOF_CHARS",
            "lejos.nxt.Button" to "ENTER LEFT RIGHT ESCAPE ID_ENTER ID_LEFT ID_RIGHT ID_ESCAPE isDown isPressed isUp " +
                "waitForPress waitForPressAndRelease waitForAnyPress waitForAnyEvent readButtons discardEvents " +
                "addButtonListener setKeyClickVolume setKeyClickTone setKeyClickLength getId",
            "lejos.nxt.ButtonListener" to "buttonPressed buttonReleased",
            "lejos.nxt.Sound" to
                "playTone beep twoBeeps beepSequence beepSequenceUp buzz systemSound playNote PIANO FLUTE " +
                "XYLOPHONE pause getTime setVolume getVolume playSample",
            "lejos.nxt.Battery" to "getVoltageMilliVolt getVoltage isRechargeable",
            "lejos.nxt.NXT" to "shutDown exit getFirmwareRevision",
            "lejos.nxt.I2CSensor" to "getData sendData getAddress setAddress",
            "lejos.nxt.TemperatureSensor" to "new getTemperature getResolution setResolution getSamplingDelay",
            "lejos.nxt.addon.AccelHTSensor" to "new getXAccel getYAccel getZAccel getAllAccel",
            "lejos.nxt.addon.AccelMindSensor" to
                "new getXAccel getYAccel getZAccel getXTilt getYTilt getZTilt getAllAccel getAllTilt",
            "lejos.nxt.addon.ColorHTSensor" to
                "new getColorID getColor getRGBComponent getRGBNormalized getRGBRaw getColorIndexNumber " +
                "getMode initWhiteBalance initBlackLevel",
            "lejos.nxt.addon.CompassHTSensor" to "new getDegrees",
            "lejos.nxt.addon.CompassMindSensor" to "new getDegrees",
            "lejos.nxt.addon.GyroSensor" to "new readValue setOffset getAngularVelocity recalibrateOffset " +
                "recalibrateOffsetAlt",
            "lejos.nxt.addon.IRSeeker" to "new getDirection getSensorValue",
            "lejos.nxt.addon.IRSeekerV2" to "new setMode getDirection getAngle hasDirection getSensorValue " +
                "getSensorValues getAverage",
            "lejos.nxt.addon.OpticalDistanceSensor" to "new getDistance getRange getRanges powerOn powerOff",
            "lejos.nxt.addon.RCXLightSensor" to "new getLightValue getNormalizedLightValue setFloodlight",
            "lejos.nxt.addon.RCXLink" to "new A B C ping sendF7 sendPacket runProgram beep readBytes sendBytes",
            "lejos.nxt.addon.RCXMotor" to "new setPower forward backward stop flt",
            "lejos.nxt.addon.RCXRotationSensor" to "new getTachoCount resetTachoCount getRotationSpeed",
            "lejos.nxt.addon.RCXThermometer" to "new readValue getCelcius getFahrenheit",
            "lejos.util.Delay" to "msDelay usDelay nsDelay",
            "lejos.util.Stopwatch" to "new reset elapsed",
            "lejos.util.TextMenu" to "new select setItems setTitle getItems quit",
            "lejos.util.Timer" to "new start stop getDelay setDelay",
            "lejos.util.TimerListener" to "timedOut",
            "lejos.util.PIDController" to
                "new setPIDParam doPID PID_KP PID_KI PID_KD PID_RAMP_POWER PID_RAMP_THRESHOLD " +
                "PID_DEADBAND PID_LIMITHIGH PID_LIMITLOW PID_SETPOINT PID_I_LIMITLOW PID_I_LIMITHIGH",
            "lejos.util.PilotProps" to "new loadPersistentValues getProperty KEY_WHEELDIAMETER getMotor",
            "lejos.robotics.RegulatedMotor" to MOTOR,
            "lejos.robotics.RegulatedMotorListener" to "rotationStarted rotationStopped",
            "lejos.robotics.DCMotor" to "setPower getPower forward backward stop flt",
            "lejos.robotics.RangeFinder" to "getRange getRanges",
            "lejos.robotics.LampLightDetector" to "setFloodlight isFloodlightOn getFloodlight getLightValue",
            "lejos.robotics.ColorDetector" to "getColor getColorID",
            "lejos.robotics.Touch" to "isPressed",
            "lejos.robotics.DirectionFinder" to
                "getDegreesCartesian resetCartesianZero startCalibration stopCalibration",
            "lejos.robotics.MirrorMotor" to "invertMotor",
            "lejos.robotics.Color" to
                "RED GREEN BLUE YELLOW MAGENTA ORANGE WHITE BLACK PINK GRAY LIGHT_GRAY DARK_GRAY CYAN NONE",
            "lejos.robotics.navigation.DifferentialPilot" to
                "new forward backward travel rotate rotateLeft rotateRight stop " +
                "quickStop arc arcForward arcBackward travelArc steer steerBackward setTravelSpeed getTravelSpeed " +
                "getMaxTravelSpeed setRotateSpeed getRotateSpeed getMaxRotateSpeed getRotateMaxSpeed setAcceleration " +
                "setMinRadius isMoving isStalled reset getMovementIncrement getAngleIncrement getMovement " +
                "addMoveListener " +
                "WHEEL_SIZE_NXT1 WHEEL_SIZE_NXT2 WHEEL_SIZE_RCX",
            "lejos.robotics.navigation.MoveListener" to "moveStarted moveStopped",
            "lejos.robotics.navigation.Move" to "getMoveType getDistanceTraveled getAngleTurned isMoving getArcRadius",
            "lejos.robotics.navigation.Pose" to "new getX getY getHeading setLocation setHeading angleTo distanceTo " +
                "relativeBearing pointAt moveUpdate rotateUpdate",
            "lejos.robotics.navigation.Waypoint" to "new",
            "lejos.robotics.pathfinding.Path" to "new add",
            "lejos.robotics.localization.OdometryPoseProvider" to "new getPose setPose",
            "lejos.robotics.navigation.Navigator" to
                "new goTo addWaypoint followPath setPath rotateTo stop clearPath " +
                "waitForStop isMoving pathCompleted getWaypoint singleStep addNavigationListener getPoseProvider " +
                "getMoveController",
            "lejos.robotics.subsumption.Behavior" to "takeControl action suppress",
            "lejos.robotics.subsumption.Arbitrator" to "new start",
            "lejos.robotics.objectdetection.FeatureDetector" to
                "addListener scan enableDetection isEnabled getDelay setDelay",
            "lejos.robotics.objectdetection.FeatureListener" to "featureDetected",
            "lejos.robotics.objectdetection.RangeFeatureDetector" to "new",
            "lejos.robotics.mapping.LineMap" to "new range inside getBoundingRect getLines",
            "lejos.robotics.pathfinding.ShortestPathFinder" to "new findRoute lengthenLines",
            "lejos.robotics.pathfinding.NodePathFinder" to "new findRoute addListener startPathFinding",
            "lejos.robotics.pathfinding.FourWayGridMesh" to "new getMesh",
            "lejos.robotics.pathfinding.AstarSearchAlgorithm" to "new findPath",
            "lejos.robotics.localization.MCLPoseProvider" to "new getPose update generateParticles getParticles",
            "lejos.robotics.FixedRangeScanner" to "new getRangeValues setAngles getRangeFinder",
            "lejos.robotics.RotatingRangeScanner" to "new getRangeValues setAngles getRangeFinder",
            "lejos.robotics.navigation.SteeringPilot" to "new travel arc travelArc calibrateSteering",
            "lejos.util.Matrix" to "new get set times plus transpose inverse solve identity print",
            "lejos.util.KalmanFilter" to "new setState update getMean getCovariance getGain",
            "lejos.util.DebugMessages" to "new echo",
            "lejos.util.NXTDataLogger" to
                "new startRealtimeLog startCachingLog writeLog finishLine setColumns sendCache stopLogging",
            "javax.microedition.lcdui.Graphics" to
                "new drawLine drawRect fillRect drawArc fillArc drawRoundRect drawString drawChar drawImage " +
                "drawRegion setFont getFont setStrokeStyle translate clear HCENTER VCENTER LEFT RIGHT " +
                "TOP BOTTOM BASELINE",
            "javax.microedition.lcdui.Font" to
                "getFont getDefaultFont getLargeFont getSmallFont stringWidth getHeight",
            "javax.microedition.lcdui.Image" to "new createImage getWidth getHeight getGraphics",
            "javax.microedition.lcdui.Display" to "getDisplay setCurrent show quit",
            "javax.microedition.lcdui.List" to "new append delete getSelectedIndex setCommandListener",
            "lejos.nxt.comm.Bluetooth" to
                "waitForConnection connect getKnownDevice getFriendlyName getLocalAddress getConnector",
            "lejos.nxt.comm.NXTConnection" to
                "openDataInputStream openDataOutputStream openInputStream openOutputStream read " +
                "write available close LCP RAW PACKET",
            "lejos.nxt.comm.RS485" to "connect waitForConnection cancelConnect getConnector",
            "lejos.nxt.comm.USB" to "waitForConnection cancelConnect getConnector",
            "lejos.nxt.comm.RConsole" to "open openUSB openAny print println close",
            "java.lang.System" to
                "out err setOut exit currentTimeMillis nanoTime arraycopy gc getProperty identityHashCode",
            "java.lang.Runtime" to "freeMemory totalMemory exit addShutdownHook getRuntime",
            "java.lang.Thread" to "start sleep yield join interrupt setPriority setDaemon currentThread getName " +
                "isAlive",
            "java.util.Timer" to "new schedule cancel",
            "java.io.File" to "new exists length getName delete createNewFile",
            "java.io.FileOutputStream" to "new write",
            "java.io.FileInputStream" to "new read",
            "lejos.geom.Line" to "new length",
            "lejos.geom.Rectangle" to "new",
            "lejos.geom.Point" to "new",
        )
    }
}
