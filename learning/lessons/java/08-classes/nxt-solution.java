import lejos.nxt.*;

public class Turtles {
    public static void main(String[] args) {
        Turtle turtle = new Turtle();
        turtle.penDown();
        for (int side = 1; side <= 6; side++) {
            turtle.forward(15);
            turtle.left(60);
        }
    }

    /** A robot that knows centimetres and degrees. */
    static class Turtle {
        void penDown() {
            Motor.B.rotateTo(90);
        }

        void forward(int centimetres) {
            int angle = centimetres * 2046 / 100;
            rotate(angle, angle);
        }

        void left(int degrees) {
            int angle = degrees * 183 / 90;
            rotate(-angle, angle);
        }

        private void rotate(int left, int right) {
            Motor.A.rotate(left, true);
            Motor.C.rotate(right);
        }
    }
}
