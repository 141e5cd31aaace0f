// hint: line too many
import josx.platform.rcx.*;

public class Turtles {
    public static void main(String[] args) throws InterruptedException {
        Turtle turtle = new Turtle();
        turtle.penDown();
        for (int side = 1; side <= 6; side++) {
            turtle.forward(15);
            turtle.left(60);
        }
        turtle.left(30);
        turtle.forward(15);
    }

    /** A robot that knows centimetres and degrees. */
    static class Turtle {
        void penDown() throws InterruptedException {
            Motor.B.forward();
            Thread.sleep(200);
            Motor.B.stop();
        }

        void forward(int centimetres) throws InterruptedException {
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(centimetres * 50);
            stop();
        }

        void left(int degrees) throws InterruptedException {
            Motor.A.backward();
            Motor.C.forward();
            Thread.sleep(degrees * 5);
            stop();
        }

        private void stop() {
            Motor.A.stop();
            Motor.C.stop();
        }
    }
}
