import java.util.Vector;
import lejos.util.IterableEnumeration;
import lejos.util.LUDecomposition;
import lejos.util.Matrix;

/** Matrices are added, multiplied, turned and inverted, and equations are solved. */
public class Matrices {
    static void print(Matrix matrix) {
        matrix.print(System.out);
    }

    static void elements() {
        Matrix a = new Matrix(new double[][] {{1, 2, 3}, {4, 5, 6}});
        print(a);
        // expect 1.0 2.0 3.0 
        // expect 4.0 5.0 6.0 
        print(a.transpose());
        // expect 1.0 4.0 
        // expect 2.0 5.0 
        // expect 3.0 6.0 
        print(a.times(a.transpose()));
        // expect 14.0 32.0 
        // expect 32.0 77.0 
        print(a.plus(a).minus(new Matrix(2, 3, 1)).arrayTimes(a).arrayRightDivide(new Matrix(2, 3, 2)));
        // expect 0.5 3.0 7.5 
        // expect 14.0 22.5 33.0 
        print(a.getMatrix(new int[] {1, 0}, 1, 2));
        // expect 5.0 6.0 
        // expect 2.0 3.0 
        print(new Matrix(new double[] {1, 2, 3, 4}, 2).uminus().timesEquals(2));
        // expect -2.0 -6.0 
        // expect -4.0 -8.0 
        System.out.println(a.norm1() + " " + a.normInf() + " " + new Matrix(1, 2, 3).transpose().getRowDimension()); // expect 9.0 15.0 2
        System.out.println(new Matrix(new double[][] {{3, 4}}).normF() + " " + Matrix.identity(3, 3).trace()); // expect 5.0 3.0
        System.out.println(a.getColumnPackedCopy()[1] + " " + a.getRowPackedCopy()[1]); // expect 4.0 2.0
        Matrix copy = a.copy();
        copy.set(0, 0, 7);
        copy.setMatrix(1, 1, 0, 1, new Matrix(1, 2, 8));
        System.out.println(a.get(0, 0) + " " + copy.get(0, 0) + " " + copy.get(1, 1) + " " + copy.get(1, 2)); // expect 1.0 7.0 8.0 6.0
    }

    static void equations() {
        Matrix a = new Matrix(new double[][] {{2, 1, 1}, {4, -6, 0}, {-2, 7, 2}});
        print(a.solve(new Matrix(new double[] {5, -2, 9}, 3)));
        // expect 1.0 
        // expect 1.0 
        // expect 2.0 
        LUDecomposition parts = new LUDecomposition(a);
        System.out.println(parts.det() + " " + parts.isNonsingular() + " " + parts.getPivot()[0]); // expect -16.0 true 1
        print(parts.getL().times(parts.getU()));
        // expect 4.0 -6.0 0.0 
        // expect 2.0 1.0 1.0 
        // expect -2.0 7.0 2.0 
        print(new Matrix(new double[][] {{4, 0}, {0, 0.5}}).inverse());
        // expect 0.25 0.0 
        // expect 0.0 2.0 
    }

    static String failure(Runnable action) {
        try {
            action.run();
            return "none";
        } catch (RuntimeException e) {
            return e.getMessage();
        }
    }

    public static void main(String[] arguments) {
        elements();
        equations();
        System.out.println(failure(new Runnable() {
            public void run() {
                new Matrix(2, 2).plus(new Matrix(2, 3));
            }
        })); // expect Matrix dimensions must agree.
        System.out.println(failure(new Runnable() {
            public void run() {
                new Matrix(2, 2).times(new Matrix(3, 2));
            }
        })); // expect Matrix inner dimensions must agree.
        System.out.println(failure(new Runnable() {
            public void run() {
                new Matrix(2, 2).inverse();
            }
        })); // expect Matrix is singular.
        System.out.println(failure(new Runnable() {
            public void run() {
                new Matrix(2, 2).getMatrix(1, 2, 0, 0);
            }
        })); // expect Submatrix indices
        Vector<String> words = new Vector<String>();
        words.addElement("one");
        words.addElement("two");
        for (String word : new IterableEnumeration<String>(words.elements())) System.out.println(word);
        // expect one
        // expect two
    }
}
