import lejos.nxt.Motor;

/** One turn of the wheels takes the robot 20 cm ahead, half a turn in opposite directions turns it by 90 degrees. */
class Turns {
    static final int SIDE = 720; // two turns
    static final int CORNER = 180; // half a turn

    public static void main(String[] args) {
        Motor.B.rotateTo(90); // pen down
        for (int side = 0; side < 4; side++) {
            turnWheels(SIDE, SIDE);
            turnWheels(-CORNER, CORNER);
        }
        Motor.B.rotateTo(0); // pen up
    }

    static void turnWheels(int left, int right) {
        Motor.A.rotate(left, true);
        Motor.C.rotate(right);
        Motor.A.waitComplete();
    }
}
