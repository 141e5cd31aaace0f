package josx.robotics;

/** Steers a robot with two wheels and knows where it is; it begins at 0, 0 and looks along x. */
public interface Navigator {
    /** Gives how far to the front of the beginning the robot stopped last. */
    float getX();

    /** Gives how far to the left of the beginning the robot stopped last. */
    float getY();

    /** Gives where the robot looks, in degrees, counted to the left. */
    float getAngle();

    /** Turns by so many degrees: to the left, or to the right if there is a minus. */
    void rotate(float angle);

    /** Turns the shorter way until the robot looks there. */
    void gotoAngle(float angle);

    /** Turns to a point and drives there. */
    void gotoPoint(float x, float y);

    /** Drives so many centimetres, backward if there is a minus. */
    void travel(int distance);

    /** Drives forward until stop is called. */
    void forward();

    /** Drives backward until stop is called. */
    void backward();

    /** Stops, and works out where the robot is now. */
    void stop();
}
