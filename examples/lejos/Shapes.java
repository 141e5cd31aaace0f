import java.util.Vector;
import josx.platform.rcx.Motor;

/** Draws shapes from a list: each kind of shape is a class that knows its corners. */
public class Shapes {
    static abstract class Shape {
        abstract int corners();

        int sideMilliseconds() {
            return 2400 / corners();
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

    static class Hexagon extends Shape {
        int corners() {
            return 6;
        }

        int sideMilliseconds() {
            return super.sideMilliseconds() * 2;
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Vector shapes = new Vector();
        shapes.addElement(new Triangle());
        shapes.addElement(new Hexagon());
        for (int index = 0; index < shapes.size(); index++) ((Shape) shapes.elementAt(index)).draw();
    }
}
