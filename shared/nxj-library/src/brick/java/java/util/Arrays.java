package java.util;

/** Sorts, fills, copies and compares arrays, searches in them, and writes them as text. */
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

    /** Sorts objects that can be compared, such as texts, the lowest first. */
    public static void sort(Object[] array) {
        sort(array, 0, array.length);
    }

    /** Sorts objects from a place up to, but not including, another, the lowest first. */
    public static void sort(Object[] array, int start, int end) {
        check(array.length, start, end);
        for (int index = start + 1; index < end; index++) {
            Object element = array[index];
            int place = index;
            while (place > start && compare(element, array[place - 1]) < 0) {
                array[place] = array[place - 1];
                place--;
            }
            array[place] = element;
        }
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(byte[] array, byte key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(byte[] array, int start, int end, byte key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = array[middle] < key ? -1 : array[middle] > key ? 1 : 0;
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(short[] array, short key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(short[] array, int start, int end, short key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = array[middle] < key ? -1 : array[middle] > key ? 1 : 0;
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(char[] array, char key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(char[] array, int start, int end, char key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = array[middle] < key ? -1 : array[middle] > key ? 1 : 0;
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(int[] array, int key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(int[] array, int start, int end, int key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = array[middle] < key ? -1 : array[middle] > key ? 1 : 0;
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(long[] array, long key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(long[] array, int start, int end, long key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = array[middle] < key ? -1 : array[middle] > key ? 1 : 0;
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(float[] array, float key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(float[] array, int start, int end, float key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = Float.compare(array[middle], key);
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(double[] array, double key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(double[] array, int start, int end, double key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = Double.compare(array[middle], key);
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Gives a place of a value in a sorted array; if it is not there, -1 minus the place where it belongs. */
    public static int binarySearch(Object[] array, Object key) {
        return binarySearch(array, 0, array.length, key);
    }

    /** Does the same from a place up to, but not including, another. */
    public static int binarySearch(Object[] array, int start, int end, Object key) {
        check(array.length, start, end);
        int low = start;
        int high = end - 1;
        while (low <= high) {
            int middle = low + high >>> 1;
            int order = compare(array[middle], key);
            if (order == 0) return middle;
            if (order < 0) {
                low = middle + 1;
            } else {
                high = middle - 1;
            }
        }
        return -1 - low;
    }

    /** Puts the same value into all elements. */
    public static void fill(byte[] array, byte value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(byte[] array, int start, int end, byte value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(short[] array, short value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(short[] array, int start, int end, short value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(char[] array, char value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(char[] array, int start, int end, char value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(int[] array, int value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(int[] array, int start, int end, int value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(long[] array, long value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(long[] array, int start, int end, long value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(float[] array, float value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(float[] array, int start, int end, float value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(double[] array, double value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(double[] array, int start, int end, double value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(boolean[] array, boolean value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(boolean[] array, int start, int end, boolean value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Puts the same value into all elements. */
    public static void fill(Object[] array, Object value) {
        fill(array, 0, array.length, value);
    }

    /** Puts the same value into the elements from a place up to, but not including, another. */
    public static void fill(Object[] array, int start, int end, Object value) {
        check(array.length, start, end);
        for (int index = start; index < end; index++) array[index] = value;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static byte[] copyOf(byte[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static byte[] copyOfRange(byte[] array, int start, int end) {
        byte[] copy = new byte[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static short[] copyOf(short[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static short[] copyOfRange(short[] array, int start, int end) {
        short[] copy = new short[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static char[] copyOf(char[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static char[] copyOfRange(char[] array, int start, int end) {
        char[] copy = new char[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static int[] copyOf(int[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static int[] copyOfRange(int[] array, int start, int end) {
        int[] copy = new int[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static long[] copyOf(long[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static long[] copyOfRange(long[] array, int start, int end) {
        long[] copy = new long[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static float[] copyOf(float[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static float[] copyOfRange(float[] array, int start, int end) {
        float[] copy = new float[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with 0 behind. */
    public static double[] copyOf(double[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with 0 behind if there are less. */
    public static double[] copyOfRange(double[] array, int start, int end) {
        double[] copy = new double[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Gives a copy so long: cut off, or with false behind. */
    public static boolean[] copyOf(boolean[] array, int length) {
        return copyOfRange(array, 0, length);
    }

    /** Gives a copy of the elements from a place up to, but not including, another, with false behind if there are less. */
    public static boolean[] copyOfRange(boolean[] array, int start, int end) {
        boolean[] copy = new boolean[lengthOf(array.length, start, end)];
        System.arraycopy(array, start, copy, 0, Math.min(array.length - start, copy.length));
        return copy;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(byte[] a, byte[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (a[index] != b[index]) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(short[] a, short[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (a[index] != b[index]) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(char[] a, char[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (a[index] != b[index]) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(int[] a, int[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (a[index] != b[index]) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(long[] a, long[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (a[index] != b[index]) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(float[] a, float[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (Float.compare(a[index], b[index]) != 0) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(double[] a, double[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (Double.compare(a[index], b[index]) != 0) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(boolean[] a, boolean[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (a[index] != b[index]) return false;
        }
        return true;
    }

    /** Says whether both arrays have the same elements. */
    public static boolean equals(Object[] a, Object[] b) {
        if (a == b) return true;
        if (a == null || b == null || a.length != b.length) return false;
        for (int index = 0; index < a.length; index++) {
            if (!AbstractCollection.isSame(a[index], b[index])) return false;
        }
        return true;
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(byte[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(short[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(char[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(int[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(long[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(float[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(double[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(boolean[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    /** Gives the elements as text, such as [1, 2]. */
    public static String toString(Object[] array) {
        if (array == null) return "null";
        StringBuilder text = new StringBuilder().append('[');
        for (int index = 0; index < array.length; index++) {
            if (index > 0) text.append(", ");
            text.append(array[index]);
        }
        return text.append(']').toString();
    }

    @SuppressWarnings("unchecked")
    private static int compare(Object a, Object b) {
        return ((Comparable<Object>) a).compareTo(b);
    }

    private static int lengthOf(int length, int start, int end) {
        if (start > end) throw new IllegalArgumentException();
        if (start < 0 || start > length) throw new ArrayIndexOutOfBoundsException();
        return end - start;
    }

    private static void check(int length, int start, int end) {
        if (start > end) throw new IllegalArgumentException();
        if (start < 0 || end > length) throw new ArrayIndexOutOfBoundsException();
    }
}
