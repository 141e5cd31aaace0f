package lejos.robotics;

/** A motor that gets as much power as the program says. */
public interface DCMotor extends BaseMotor {
    /** Sets the power, 0 to 100. */
    void setPower(int power);

    /** Gives the power. */
    int getPower();
}
