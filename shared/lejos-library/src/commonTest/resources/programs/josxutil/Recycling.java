import josx.platform.rcx.LCD;
import josx.util.AbstractRecyclable;
import josx.util.ArrayRecycler;
import josx.util.Recyclable;
import josx.util.RecyclableArray;
import josx.util.Recycler;

public class Recycling {
    static int made = 0;

    static class Ball extends AbstractRecyclable {
        int throwsLeft;

        public void init() {
            throwsLeft = 3;
        }

        public void release() {
            throwsLeft = 0;
        }
    }

    static class Balls extends Recycler {
        protected Recyclable createInstance() {
            made++;
            return new Ball();
        }
    }

    public static void main(String[] arguments) {
        Balls balls = new Balls();
        Ball first = (Ball) balls.allocate();
        LCD.showNumber(first.throwsLeft); // shows: 3
        balls.recycle(first);
        LCD.showNumber(first.throwsLeft); // shows: 0
        LCD.showNumber(balls.allocate() == first ? 1 : 0); // shows: 1
        balls.allocate();
        LCD.showNumber(made); // shows: 2
        ArrayRecycler arrays = new ArrayRecycler();
        RecyclableArray array = arrays.allocate(3);
        array.put(2, "x");
        LCD.showNumber(array.getLength()); // shows: 3
        arrays.recycle(array);
        LCD.showNumber(array.getLength()); // shows: 0
        LCD.showNumber(arrays.allocate(5) == array ? 1 : 0); // shows: 0
        RecyclableArray shorter = arrays.allocate(2);
        LCD.showNumber(shorter == array ? 1 : 0); // shows: 1
        LCD.showNumber(shorter.get(1) == null ? 1 : 0); // shows: 1
        try {
            shorter.get(2);
        } catch (ArrayIndexOutOfBoundsException tooFar) {
            LCD.showNumber(8); // shows: 8
        }
    }
}
