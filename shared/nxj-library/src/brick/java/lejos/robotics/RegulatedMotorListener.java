package lejos.robotics;

/** Is told when a motor begins to move and when it stops. */
public interface RegulatedMotorListener {
    /** The motor begins to move: its degrees then, and when that was. */
    void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp);

    /** The motor has stopped: its degrees then, whether something kept it from moving on, and when that was. */
    void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp);
}
