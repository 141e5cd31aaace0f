package java.util;

/** Sorts arrays. */
public class Arrays {
    private Arrays() {
    }

    /** Sorts the array, the lowest first. */
    public static void sort(byte[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(byte[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            byte element = array[index];
            int place = index;
            while (place > start && element < array[place - 1]) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Sorts the array, the lowest first. */
    public static void sort(short[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(short[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            short element = array[index];
            int place = index;
            while (place > start && element < array[place - 1]) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Sorts the array, the lowest first. */
    public static void sort(char[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(char[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            char element = array[index];
            int place = index;
            while (place > start && element < array[place - 1]) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Sorts the array, the lowest first. */
    public static void sort(int[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(int[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            int element = array[index];
            int place = index;
            while (place > start && element < array[place - 1]) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Sorts the array, the lowest first. */
    public static void sort(long[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(long[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            long element = array[index];
            int place = index;
            while (place > start && element < array[place - 1]) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Sorts the array, the lowest first. */
    public static void sort(float[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(float[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            float element = array[index];
            int place = index;
            while (place > start && Float.compare(element, array[place - 1]) < 0) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Sorts the array, the lowest first. */
    public static void sort(double[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts the elements from a place up to, but not including, another, the lowest first. */
    public static void sort(double[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            double element = array[index];
            int place = index;
            while (place > start && Double.compare(element, array[place - 1]) < 0) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    private static void check(int length, int start, int end) {
        if (start > end) throw new IllegalArgumentException();
        if (start < 0 || end > length) throw new ArrayIndexOutOfBoundsException();
    }
}
