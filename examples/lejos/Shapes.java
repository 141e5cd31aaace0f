// Draws a triangle and a hexagon. Each kind of shape is a class that
// knows its corners; what all of them do is in the class Shape.
// Next: write a class for a pentagon.

import josx.platform.rcx.Motor;

public class Shapes {
    public static void main(String[] args) throws InterruptedException {
        Shape[] shapes = {new Triangle(), new Hexagon()};
        Motor.B.forward(); // the pen goes down
        Thread.sleep(200);
        Motor.B.stop();
        for (int index = 0; index < shapes.length; index++) shapes[index].draw();
    }

    abstract static class Shape {
        abstract int corners();

        int sideMilliseconds() {
            return 3000 / corners();
        }

        void draw() throws InterruptedException {
            for (int corner = 0; corner < corners(); corner++) {
                Motor.A.forward();
                Motor.C.forward();
                Thread.sleep(sideMilliseconds());
                Motor.A.backward();
                Thread.sleep(1800 / corners());
            }
            Motor.A.stop();
            Motor.C.stop();
        }
    }

    static class Triangle extends Shape {
        int corners() {
            return 3;
        }
    }

    /** Twice as large as others. */
    static class Hexagon extends Shape {
        int corners() {
            return 6;
        }

        int sideMilliseconds() {
            return 2 * super.sideMilliseconds();
        }
    }
}
