import josx.platform.rcx.LCD;
import josx.util.AbstractRecyclable;
import josx.util.ArrayRecycler;
import josx.util.Recyclable;
import josx.util.RecyclableArray;
import josx.util.Recycler;

public class RecyclablesByHand {
    static class Coin extends AbstractRecyclable {
        public void init() {
        }

        public void release() {
        }
    }

    /** A recyclable that keeps its neighbour itself. */
    static class Note implements Recyclable {
        private Recyclable next;

        public void init() {
        }

        public void release() {
        }

        public Recyclable getNextRecyclable() {
            return next;
        }

        public void setNextRecyclable(Recyclable next) {
            this.next = next;
        }
    }

    static class Notes extends Recycler {
        protected Recyclable createInstance() {
            return new Note();
        }
    }

    public static void main(String[] arguments) {
        Coin coin = new Coin();
        coin.setNextRecyclable(new Note());
        LCD.showNumber(coin.getNextRecyclable() instanceof Note ? 1 : 0); // shows: 1
        Notes notes = new Notes();
        Recyclable first = notes.allocate();
        Recyclable second = notes.allocate();
        notes.recycle(first);
        notes.recycle(second);
        LCD.showNumber(notes.allocate() == notes.allocate() ? 1 : 0); // shows: 0
        LCD.showNumber(first.getNextRecyclable() == null ? 1 : 0); // shows: 1
        RecyclableArray array = new ArrayRecycler().allocate(2);
        array.put(0, "x");
        array.release();
        array.init();
        LCD.showNumber(array.getLength()); // shows: 0
        ArrayRecycler arrays = new ArrayRecycler();
        RecyclableArray longer = arrays.allocate(4);
        RecyclableArray shorter = arrays.allocate(1);
        arrays.recycle(longer);
        arrays.recycle(shorter);
        LCD.showNumber(arrays.allocate(3) == longer ? 1 : 0); // shows: 1
        LCD.showNumber(arrays.allocate(1) == shorter ? 1 : 0); // shows: 1
    }
}
