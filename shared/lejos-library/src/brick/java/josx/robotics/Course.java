package josx.robotics;

/** Where a robot is and where it looks. */
class Course {
    float x;
    float y;
    float angle;

    /** How far the robot has to turn to look somewhere, the shorter way. */
    float wayTo(float wanted) {
        float way = wanted - angle;
        while (way > 180f) way -= 360f;
        while (way < -180f) way += 360f;
        return way;
    }

    /** The direction of a point, in degrees. */
    float directionOf(float pointX, float pointY) {
        return (float) Math.toDegrees(Math.atan2(pointY - y, pointX - x));
    }

    /** How far away a point is, to the nearest whole number. */
    int distanceOf(float pointX, float pointY) {
        float right = pointX - x;
        float up = pointY - y;
        return Math.round((float) Math.sqrt(right * right + up * up));
    }

    /** Notes a turn; the angle is kept in whole degrees from 0 to 359. */
    void turn(float degrees) {
        int whole = (int) (angle + degrees) % 360;
        angle = whole < 0 ? whole + 360 : whole;
    }

    /** Notes a drive straight on. */
    void advance(float distance) {
        double radians = Math.toRadians(angle);
        x += (float) Math.cos(radians) * distance;
        y += (float) Math.sin(radians) * distance;
    }
}
